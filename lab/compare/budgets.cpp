#include "lab/compare/budgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/failure.h"
#include "lab/parsing.h"

namespace wander::compare {

namespace {

// What cannot be given to every method alike is no budget of a comparison.
void require_fixed(const NamedBudget& budget) {
  if (std::holds_alternative<SampleBudget>(budget.budget) ||
      std::holds_alternative<TimeBudget>(budget.budget))
    return;
  throw UsageError(fmt::format(
      "budget '{}': a comparison takes samples, seconds or processor seconds", budget.text));
}

bool are_alike(const Budget& a, const Budget& b) {
  return a.index() == b.index() && time_kind_of(a) == time_kind_of(b);
}

}  // namespace

std::vector<NamedBudget> parse_budgets(std::string_view text) {
  std::vector<NamedBudget> budgets;
  for (const std::string_view part : split(text, ',')) {
    budgets.push_back({std::string(part), parse_budget(part)});
    require_fixed(budgets.back());
    if (!are_alike(budgets.back().budget, budgets.front().budget))
      throw UsageError(fmt::format(
          "budgets '{}': give all in samples, all in seconds or all in processor seconds", text));
  }
  std::ranges::sort(budgets, {}, [](const NamedBudget& b) { return effort_of(b.budget); });
  for (std::size_t i = 1; i < budgets.size(); ++i)
    if (effort_of(budgets[i].budget) == effort_of(budgets[i - 1].budget))
      throw UsageError(
          fmt::format("budgets '{}' and '{}' are the same", budgets[i - 1].text, budgets[i].text));
  return budgets;
}

bool are_the_same(const std::vector<NamedBudget>& a, const std::vector<NamedBudget>& b) {
  return std::ranges::equal(
      a, b, [](const NamedBudget& x, const NamedBudget& y) { return x.budget == y.budget; });
}

double effort_of(const Budget& budget) {
  if (const auto* time = std::get_if<TimeBudget>(&budget)) return time->seconds;
  return static_cast<double>(std::get<SampleBudget>(budget).samples);
}

Budget budget_of(double effort, const Budget& like) {
  if (std::holds_alternative<TimeBudget>(like)) return TimeBudget{effort, time_kind_of(like)};
  return SampleBudget{static_cast<std::uint64_t>(std::round(effort))};
}

std::string text_of(const Budget& budget) {
  if (const auto* time = std::get_if<TimeBudget>(&budget))
    return fmt::format("{:.6g}{}s", time->seconds, time->kind == TimeKind::wall ? "" : "cpu-");
  return std::to_string(std::get<SampleBudget>(budget).samples);
}

}  // namespace wander::compare
