#include "mlt/normalization.h"

#include <cmath>
#include <limits>

namespace wander {

namespace {

Estimate mean(const Sum& sum, const Sum& squares, std::uint64_t samples) {
  const double n = static_cast<double>(samples), m = sum.value() / n;
  if (samples < 2) return {m, std::numeric_limits<double>::quiet_NaN()};
  const double variance = std::max(0.0, squares.value() / n - m * m) / (n - 1);
  return {m, std::sqrt(variance)};
}

}  // namespace

Normalization normalization(const SeedTally& tally) {
  Normalization b;
  static_cast<Estimate&>(b) = mean(tally.total, tally.total_squares, tally.samples);
  b.method = "seed_pass";
  b.estimates[b.method] = {{b.value, b.standard_error}, tally.samples};
  for (std::size_t k = 0; k < tally.sum.size(); ++k) {
    if (tally.sum[k].value() == 0) continue;
    b.by_length.push_back(
        {mean(tally.sum[k], tally.squares[k], tally.samples), static_cast<int>(k) + 2});
  }
  return b;
}

}  // namespace wander
