#include "tests/support/invariance.h"

#include <cmath>

namespace wander::test {

namespace {

bool enough(double magnitude, double square) {
  return square > 0 && magnitude * magnitude >= fewest_contributions * square;
}

Decision largest(const std::vector<double>& z, const char* test, double false_alarm) {
  if (z.empty())
    return {.test = test, .p_value = 0, .false_alarm = false_alarm, .detail = nothing_moved};
  Decision decision = largest_z_test(z, false_alarm);
  decision.test = test;
  return decision;
}

}  // namespace

Decision Deviations::decide(std::uint64_t samples, double false_alarm) const {
  const auto n = static_cast<double>(samples);
  std::vector<double> z;
  for (const Sums& s : sums_) {
    if (!enough(s.magnitude, s.square)) continue;
    const double mean = s.value / n, variance = (s.square / n - mean * mean) / (n - 1);
    z.push_back(mean / std::sqrt(variance));
  }
  return largest(z, "invariance", false_alarm);
}

Decision Flux::decide(double false_alarm) const {
  std::vector<double> z;
  for (std::size_t i = 0; i < cells_; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Entry &there = entries_[i * cells_ + j], &back = entries_[j * cells_ + i];
      const double square = there.square + back.square;
      if (!enough(there.flow + back.flow, square)) continue;
      z.push_back((there.flow - back.flow) / std::sqrt(square));
    }
  }
  return largest(z, "balance of flux", false_alarm);
}

}  // namespace wander::test
