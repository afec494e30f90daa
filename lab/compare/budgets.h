// The budgets of a comparison: several, all samples or all seconds, from small to large.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "work/session.h"

namespace wander::compare {

struct NamedBudget {
  std::string text;  // as given: "1s", "2M"
  Budget budget;
};

// "0.25s,1s,4s".  Throws UsageError that says what is allowed.
std::vector<NamedBudget> parse_budgets(std::string_view text);
// However they are written.
bool are_the_same(const std::vector<NamedBudget>& a, const std::vector<NamedBudget>& b);

// Seconds, or samples: what adds up over runs.
double effort_of(const Budget& budget);
// Of the same kind as `like`; whole samples.
Budget budget_of(double effort, const Budget& like);
// "48s", "0.3cpu-s", "20000000": as -b takes it, seconds to six digits.
std::string text_of(const Budget& budget);

}  // namespace wander::compare
