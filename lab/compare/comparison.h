// What a comparison of methods has found: errors with intervals, who is ahead from when on, and how
// long each takes to a given error.  Made of Runs by summarize(); read by the writers of
// compare.json and compare.csv and by the report.
//
// With R replicates of a film x_r, a reference I whose standard error is e, and Σ over bins (of an
// image, over the channels of its pixels),
//   relative MSE of a run   m_r = (Σ (x_r - I)² - Σ e²) / Σ I²
//   relative RMSE           √(mean_r m_r)
// The reference's own error, Σ e², is subtracted.
// Intervals hold 95 %: they are over replicates, and know that the reference has an error
// (plausible.h, cells.h).  What is not known is NaN: every interval where there is one replicate,
// and a bound beyond which nothing is excluded.
#pragma once

#include <string>
#include <vector>

#include "lab/compare/run_errors.h"
#include "lab/compare/runs.h"

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
  // No run found any light, where there is some: the error is that of a film that is black.
  bool is_dark = false;
  // Medians; the interval is the range of the replicates.
  Measured seconds{}, samples{};
  Measured relative_rmse;  // √(Σ(x-I)² / Σ I²), root of the mean square over replicates
  Measured median_relative_rmse;  // median over replicates of the error of one run
  Measured rmse, mae;             // in the units of the film; the mae holds the reference's error
  Measured rel_mse;  // mean over bins of ((x-I)² - e²) / (I² + (0.01 mean I)²); may be negative
  Measured bias;     // relative: signed root of the estimate of Σ bias² / Σ I²
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
  // The slope over log seconds is compatible with -1/2: its interval holds it, or it is within 0.1.
  bool inverse_root = false;
  // To the target error of the comparison.  Where the slope is compatible, relative RMSE at t
  // seconds = √(constant / t), of all cells together, up to 4 times the longest run; beyond that
  // run it is extrapolated (curves.h).  Elsewhere interpolated between the budgets, log over log.
  // 0 if the first budget reaches it.
  Measured seconds_to_target;
};

// Where the curves of two contenders meet, if one is ahead from there on.
struct Crossing {
  std::size_t ahead = 0, behind = 0;  // contenders
  // From this time on, interpolated between the budgets and never extrapolated: 0 at the first or
  // before; not known where `ahead` has more error at the end of the time that both have measured.
  Measured seconds;
  bool significant = false;    // ahead at the decisive budget beyond chance (5 %, all pairs)
  double p_value = not_known;  // two-sided, corrected for all pairs [Holm 1979]
  Measured speedup;            // relative MSE of `behind` over that of `ahead`
  Measured efficiency;         // of `ahead` over that of `behind`: speedup at equal time
};

// Empirical distribution of the seconds to the target, over replicates [Dolan and Moré 2002].
struct Profile {
  std::size_t contender = 0;
  std::vector<double> seconds{}, share{};  // share of replicates that need no more; ascending
};

struct Comparison {
  Runs runs;
  std::vector<RunErrors> errors{};  // of runs.runs
  // Relative error of `seconds_to_target`: what was asked for, or else the least of 1, 2, 5, 10 ...
  // that a contender has reached at the decisive budget.
  double target = not_known;
  std::size_t decisive = 0;   // the last budget at which all contenders were measured
  std::vector<Cell> cells{};  // [contender][budget]
  std::vector<Curve> curves{};
  std::vector<Crossing> crossings{};  // each pair once
  std::vector<Profile> profiles{};
  std::vector<std::size_t> ranking{};  // contenders at the decisive budget, least error first
  // In words, most important first; says what is not significant.  Up to six sentences.
  std::vector<std::string> verdict{};
  std::vector<std::string> cautions{};  // why to doubt it; the first of them are in the verdict
};

// Throws std::invalid_argument if films and reference differ in their number of bins, or a run is
// of a contender or budget that does not exist.
Comparison summarize(Runs runs);

}  // namespace wander::compare
