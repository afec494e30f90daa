// What a comparison of methods has found: errors with intervals, who is ahead from when on, and how
// long each takes to a given error.  Made of Runs by summarize(); read by the writers of
// compare.json and compare.csv and by the report.
//
// With R replicates of a film x_r, a reference I whose standard error is e, and Σ over bins,
//   relative MSE of a run   m_r = (Σ (x_r - I)² - Σ e²) / Σ I²       [the reference's error is
//   subtracted] relative RMSE           √(mean_r m_r)
// Intervals hold 95 %: they are over replicates, and know that the reference has an error.
#pragma once

#include <string>
#include <vector>

#include "tools/compare/runs.h"

namespace wander::compare {

struct Interval {
  double low = not_known, high = not_known;
};

struct Measured {
  double value = not_known;
  Interval interval{};
};

// A contender at a budget: a point of its curve.
struct Cell {
  std::size_t contender = 0, budget = 0, replicates = 0;
  Measured seconds, samples;  // medians; the interval is the range of the replicates
  Measured relative_rmse;     // √(Σ(x-I)² / Σ I²), root of the mean square over replicates
  Measured median_relative_rmse;    // median over replicates of the error of one run
  Measured rmse, mae;               // in the units of the film
  Measured rel_mse;                 // mean over bins of (x-I)² / (I² + (0.01 mean I)²)
  Measured bias;                    // relative: signed root of the estimate of Σ bias² / Σ I²
  Measured relative_error_of_mean;  // (mean film - mean I) / mean I
  double claimed_relative_error =
      not_known;                // √(Σ se² / Σ value²), median: what runs say themselves
  double coverage = not_known;  // share of reliable bins whose 95 % interval holds the reference
  Measured efficiency;          // 1 / (relative MSE × seconds)
};

// A contender over all its budgets.
struct Curve {
  std::size_t contender = 0;
  Measured slope_time, slope_samples;  // of log relative_rmse over log seconds, log samples
  // Relative RMSE at t seconds ≈ √(constant / t): of all cells together, where the slope allows.
  Measured seconds_to_target;  // to the target error of the comparison
};

// Where the curves of two contenders meet, if one is ahead from there on.
struct Crossing {
  std::size_t ahead = 0, behind = 0;  // contenders
  Measured seconds;                   // from this time on; the first budget or before: 0
  bool significant = false;           // ahead at the last budget beyond chance (5 %, all pairs)
  Measured speedup;                   // relative MSE of `behind` over that of `ahead`, last budget
};

// Empirical distribution of the seconds to the target, over replicates [Dolan and Moré 2002].
struct Profile {
  std::size_t contender = 0;
  std::vector<double> seconds{}, share{};  // share of replicates that need no more; ascending
};

struct Comparison {
  Runs runs;
  double target = not_known;  // relative error of `seconds_to_target`
  std::vector<Cell> cells{};  // [contender][budget]
  std::vector<Curve> curves{};
  std::vector<Crossing> crossings{};  // each pair once
  std::vector<Profile> profiles{};
  std::vector<std::size_t> ranking{};  // contenders at the last budget, least error first
  std::vector<std::string>
      verdict{};  // in words, most important first; says what is not significant
};

Comparison summarize(Runs runs);

}  // namespace wander::compare
