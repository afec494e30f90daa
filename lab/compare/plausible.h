// What the mean of a positive, skewed quantity can plausibly be, given few replicates of it.
//
// The squared error D_r of run r has unknown skewness: where the bins of a film err independently
// it hardly varies, and where they err together (an MLT film shares the error of its normalization)
// it is σ²χ² with one degree of freedom.  No resampling of four or eight such values knows how long
// its tail is, so draws of E D come from three sources, a third each:
//
//   gamma      D_r ~ Γ(a), scaled: the law of a sum of squared normal errors [Satterthwaite 1946].
//              Given a, E D = R a D̄ / G with G ~ Γ(Ra).  With the prior dμ/μ da/a, which matches
//              frequencies to first order [Tibshirani 1989], log p(a | D) + log a =
//                R a log(GM/D̄) - R log Γ(a) + log Γ(Ra) - R a log R,   GM the geometric mean
//   lognormal  runs of very different quality.  log D_r ~ N(λ, σ²), σ² = ψ'(a), σ at most 1.5:
//                log E D = mean log D + σ z/√R + σ²/2,   with dλ da/a
//   Student    log E D = log D̄ + t s/(D̄ √R),  t of R - 1 degrees: what holds for large R
//
// The two densities of a share their weight, tempered by a power of 1/2, for neither is the truth
// [Grünwald and van Ommen 2017]; and log(E D / D̄) is stretched by 1.15.  Both numbers are
// calibrated by simulation.  Measured coverage of the 95 % interval over 2000 comparisons each
// (tests/lab/compare/plausible_long_test.cpp), for R = 2, 4, 8, 16, 32 replicates:
//
//                                             these draws           percentile bootstrap
//   64 independent normal bins              .99 .99 .98 .99 .99     .50 .81 .90 .92 .94
//   all bins err together                   .94 .96 .98 .98 .98     .42 .70 .79 .87 .91
//   half of the error in common             .97 .97 .96 .95 .94     .42 .68 .82 .86 .91
//   Student's t of 5 degrees, independent   .98 .99 .98 .97 .97     .47 .77 .85 .90 .91
//   runs of uneven quality, CV² = 1.7       .97 .98 .98 .98 .98     .42 .68 .78 .85 .88
//
// One run in ten with sixteen times the square error is beyond any method at R = 4 (.47, and .90 at
// R = 32): what no replicate has seen is in no interval.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/compare/comparison.h"

namespace wander::compare {

using Draws = std::vector<double>;
inline constexpr std::size_t draw_count = 4000;
// So many, or more, that a difference can be significant among those of all pairs: of n draws no p-value is below
// 2 / (n + 1), and Holm's method multiplies the smallest by the number of pairs.
std::size_t draw_count_of(std::size_t contenders);

// Draws of E D from replicates of D >= 0; streams are independent.  None for a single replicate.
Draws draws_of_mean(std::span<const double> replicates, std::uint32_t stream,
                    std::size_t count = draw_count);

// Draws of the reference's error in units of its standard error, t of so many degrees.
Draws draws_of_reference(double degrees, std::size_t count = draw_count);

// The quantiles 0.025 and 0.975, widened to hold `value`; a bound that is not finite is not known.
// Unknown as a whole where there are no draws, or more than 2.5 % of them are not numbers.
Interval interval_of(Draws draws, double value);
// Interval from draws of a function f of parameters; value is f of the estimates.
Measured measured(double value, const Draws& draws);

}  // namespace wander::compare
