// A short trial of all methods that could make a reference: how much a sample of each tells of the
// film, and how long it takes.
//
// Each method makes a few small independent runs, by turns with the others.  With x_m the mean of
// the films of method m, and V_m the variance of x_m per bin, by what the runs claim or by what
// they differ, whichever is more (lab/film_pool.h), its variance is
//
//   Σ V_m + max_k Σ_{x_k > x_m} ((x_k - x_m)² - V_m - 4 V_k)     if the maximum is above zero
//
// for small runs are optimistic where light is rare: those that miss it do not know of it.  Whoever
// finds nothing of a light u in n samples has, for this alone, a variance of about u² or more.  So
// light that another method k has found beyond two standard errors counts as an error of m.
#pragma once

#include <string>
#include <vector>

#include "lab/compare/course.h"
#include "lab/compare/make_runs.h"
#include "records/rendering.h"

namespace wander::compare {

// What one sample of a method is worth.
struct Worth {
  std::string method;
  double information =
      0;  // 1 / (variance × samples), in one unit for all methods; 0: found nothing
  double seconds = 0;

  double efficiency() const { return seconds > 0 ? information / seconds : 0; }
};

struct Candidate {
  std::string method;
  std::vector<Rendering> runs{};  // one at least
};
// The most efficient first.
std::vector<Worth> ranked(const std::vector<Candidate>& candidates);

// Together about 3 % of the comparison, but no run less than 2000 samples or a fiftieth of a second; where that is more than
// these 3 %, chains take no part.  None after an interruption.  A method whose chains find no light
// takes no part.
std::vector<Worth> hold_trial(const Plan& plan, Course& course);

// All runs of the trial together, as hold_trial() counts them (effort_of).
double trial_effort(const Plan& plan);

}  // namespace wander::compare
