// How long a comparison will take, said before it begins.
#pragma once

#include <string>
#include <vector>

#include "lab/compare/course.h"
#include "lab/compare/make_runs.h"

namespace wander::compare {

// How long a contender takes for a budget of samples: so long for each, and for each sample of the
// seed pass, which is a share of the others but no smaller than `fewest_seeds`.
struct Pace {
  double of_sample = 0, of_seed = 0;  // seconds
  double seed_share = 0, fewest_seeds = 0;

  double seconds(double samples) const;
};
// Of each contender, from a small run; zero where it finds no light.  Empty where budgets are
// seconds, for nothing need be known there.
using Paces = std::vector<Pace>;
Paces paces_of(const Plan& plan, Course& course);
double effort_of_paces(const Plan& plan);  // of these small runs together (effort_of)

struct Forecast {
  std::size_t runs = 0;
  std::string budgets{};    // "0.25s, 1s, 4s"
  double longest = 0;       // seconds of the longest run of the plan
  double of_runs = 0;       // seconds of all runs
  double of_reference = 0;  // seconds of what is still to be made of it

  double seconds() const { return of_runs + of_reference; }
};
// `turns`: those that are to come.
Forecast forecast(const Plan& plan, const Paces& paces, const std::vector<Turn>& turns);

// "48 runs of 0.25s, 1s, 4s, and a reference of about 60 s: about 3 min 10 s"
std::string in_words(const Forecast& forecast);
// The same as a line of --progress json, of phase "forecast".
std::string json_line_of(const Forecast& forecast);

}  // namespace wander::compare
