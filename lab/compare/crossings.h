// Contenders against each other: who is ahead, from when on, by how much, and whether by chance.
//
// The p-value of a pair is that of the ratio of their mean square errors at the decisive budget:
// twice the share of draws on the wrong side of 1.  A test of log m_r (Welch, permutations) would
// hold medians against each other, and take a method whose errors are skewed for a better one.
// Corrected for all pairs by Holm's method [1979].
#pragma once

#include "lab/compare/measurements.h"

namespace wander::compare {

// Contenders by their error at a budget, least first; those without one come last.
std::vector<std::size_t> ranking_at(const Measurements& all, std::size_t budget);

// Each pair once, `ahead` before `behind` in the ranking.
std::vector<Crossing> measure_crossings(const Measurements& all,
                                        const std::vector<std::size_t>& ranking,
                                        std::size_t budget);

// Holm's adjusted p-values; what is not known stays so and counts as a comparison.
std::vector<double> holm(const std::vector<double>& p_values);

}  // namespace wander::compare
