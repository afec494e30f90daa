#include "draw/report/spread.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

namespace wander::report {
namespace {

// Squares of very bright or dark films would leave the range of a double.
double largest_value(const std::vector<const Run*>& replicates) {
  double largest = 0;
  for (const Run* run : replicates)
    for (const double value : run->film.value)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

struct Variances {
  double between = 0, claimed = 0;
};

Variances variances_of_bin(const std::vector<const Run*>& replicates, std::size_t bin,
                           double unit) {
  const auto count = static_cast<double>(replicates.size());
  Variances result;
  double mean = 0;
  for (const Run* run : replicates) {
    mean += run->film.value[bin] / unit / count;
    const double error = run->film.standard_error[bin] / unit;
    result.claimed += error * error / count;
  }
  for (const Run* run : replicates) {
    const double difference = run->film.value[bin] / unit - mean;
    result.between += difference * difference / (count - 1);
  }
  return result;
}

// Without degrees of freedom the claimed errors count as exact: a large number of them.
compare::Interval expected_ratio(const std::vector<const Run*>& replicates) {
  constexpr double exact = 1e6;
  double degrees = 0;
  for (const Run* run : replicates) degrees += run->film.degrees_of_freedom;
  const double within = std::isfinite(degrees) && degrees > 0 ? std::min(degrees, exact) : exact;
  const boost::math::fisher_f f(static_cast<double>(replicates.size() - 1), within);
  return {std::sqrt(boost::math::quantile(f, 0.025)), std::sqrt(boost::math::quantile(f, 0.975))};
}

}  // namespace

SeedSpread spread_of(const std::vector<const Run*>& replicates) {
  SeedSpread spread;
  spread.replicates = replicates.size();
  if (replicates.size() < 2) return spread;
  spread.expected = expected_ratio(replicates);
  const double unit = largest_value(replicates);
  Variances sum;
  for (std::size_t bin = 0; bin < replicates.front()->film.value.size(); ++bin) {
    const Variances variances = variances_of_bin(replicates, bin, unit);
    const bool known = std::isfinite(variances.between) && variances.claimed > 0;
    spread.ratio.push_back(known ? std::sqrt(variances.between / variances.claimed) : not_known);
    if (!known) continue;
    sum.between += variances.between;
    sum.claimed += variances.claimed;
    ++spread.bins;
    const double ratio = spread.ratio.back();
    if (ratio < spread.expected.low || ratio > spread.expected.high) ++spread.beyond;
  }
  spread.pooled = std::sqrt(sum.between / sum.claimed);
  return spread;
}

}  // namespace wander::report
