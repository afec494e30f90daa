// Pearson's χ² over cells, with pooling of the thin ones.
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "statistics/visible_error.h"
#include "tests/support/statistics.h"

namespace wander::test {

namespace {

struct Pool {
  double observed = 0, expected = 0;
  std::size_t cell = 0;  // its member with the largest expectation

  double term() const { return (observed - expected) * (observed - expected) / expected; }
};

// Cells in rising order of expectation, the thin ones joined until each pool is thick enough.
std::vector<Pool> pooled(std::span<const double> observed, std::span<const double> expected) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  std::vector<Pool> pools;
  Pool open;
  for (const std::size_t cell : order) {
    if (expected[cell] == 0) continue;
    open = {open.observed + observed[cell], open.expected + expected[cell], cell};
    if (open.expected < smallest_expected_count) continue;
    pools.push_back(open);
    open = {};
  }
  // Only when all cells together are too thin is a pool left over: then nothing can be tested.
  return pools;
}

// The first cell whose numbers cannot belong to any histogram of these expectations, in words.
std::string impossible_cell(std::span<const double> observed, std::span<const double> expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const bool sound = std::isfinite(expected[i]) && expected[i] >= 0;
    if (sound && !(expected[i] == 0 && observed[i] > 0)) continue;
    std::ostringstream text;
    text << "cell " << i << " holds " << observed[i] << " where " << expected[i] << " are expected";
    return text.str();
  }
  return {};
}

// If the cells held more and less by turns, by this share of what is expected: Pearson's sum would have
// the noncentrality N share².
double visible_share(std::span<const double> expected, double degrees, double threshold) {
  const double all = std::accumulate(expected.begin(), expected.end(), 0.0);
  using Law = boost::math::non_central_chi_squared;
  return std::sqrt(Law::find_non_centrality(degrees, threshold, 1 - power_of_visible) / all);
}

}  // namespace

Decision chi_square_test(std::span<const double> observed, std::span<const double> expected,
                         double false_alarm, std::size_t fitted) {
  if (observed.size() != expected.size())
    throw std::invalid_argument("a χ² test needs an expectation for each cell");
  Decision d{.test = "Pearson's χ²", .p_value = 0, .false_alarm = false_alarm};
  d.detail = impossible_cell(observed, expected);
  if (!d.detail.empty()) return d;
  const std::vector<Pool> pools = pooled(observed, expected);
  if (pools.size() < 2 + fitted) {
    d.detail = "too few cells with an expected count of 5 or more";
    return d;
  }
  const auto worst = std::max_element(
      pools.begin(), pools.end(), [](const Pool& a, const Pool& b) { return a.term() < b.term(); });
  for (const Pool& pool : pools) d.statistic += pool.term();
  const boost::math::chi_squared distribution{static_cast<double>(pools.size() - 1 - fitted)};
  d.threshold = boost::math::quantile(boost::math::complement(distribution, false_alarm));
  d.p_value = boost::math::cdf(boost::math::complement(distribution, d.statistic));
  d.passed = d.statistic <= d.threshold;
  d.visible = visible_share(expected, distribution.degrees_of_freedom(), d.threshold);
  d.comparisons = pools.size();
  d.worst = worst->cell;
  std::ostringstream text;
  text << pools.size() - 1 - fitted << " degrees of freedom; worst cell holds " << worst->observed
       << ", expected " << worst->expected;
  d.detail = text.str();
  return d;
}

Decision uniformity_test(std::span<const double> values, double false_alarm, std::size_t cells) {
  std::vector<double> observed(cells, 0.0);
  const auto width = static_cast<double>(cells);
  const std::vector<double> expected(cells, static_cast<double>(values.size()) / width);
  for (const double value : values) {
    if (!(value >= 0 && value <= 1)) throw std::invalid_argument("a value lies outside [0, 1]");
    const auto cell = static_cast<std::size_t>(value * width);
    ++observed[std::min(cell, cells - 1)];
  }
  Decision d = chi_square_test(observed, expected, false_alarm);
  d.test = "uniformity by " + d.test;
  return d;
}

}  // namespace wander::test
