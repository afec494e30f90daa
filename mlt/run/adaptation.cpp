#include "mlt/run/adaptation.h"

#include <cmath>
#include <limits>

namespace wander {

void WindowSpread::add(std::span<const double> shares) {
  ++count_;
  for (std::size_t j = 0; j < sums_.size(); ++j) {
    sums_[j] += shares[j];
    squares_ += shares[j] * shares[j];
  }
}

double WindowSpread::value() const {
  if (count_ < 2) return std::numeric_limits<double>::infinity();
  double between = squares_;
  for (const double sum : sums_) between -= sum * sum / count_;
  return between / (count_ - 1);
}

void KernelSearch::tell(double spread) {
  const double factor = *next_;
  const bool is_first = found_.tried.empty();
  found_.tried.push_back({factor, spread});
  if (is_first || spread * least_gain < least_) {
    found_.kernel = factor;
    least_ = spread;
    return go_on_from(factor);
  }
  // Larger ones are no better, and smaller ones have not been tried.
  if (ratio_ > 1 && found_.kernel == 1) {
    ratio_ = 1 / ratio_of_kernels;
    return go_on_from(found_.kernel);
  }
  next_.reset();
}

void KernelSearch::go_on_from(double factor) {
  const double further = factor * ratio_;
  next_.reset();
  if (further >= smallest_kernel && further <= largest_kernel) next_ = further;
}

std::uint64_t seed_of_adaptation(std::uint64_t seed) {
  // As that of the pilot (pilot.h), and another.
  return (seed ^ 0x6164617074) * 0x9E3779B97F4A7C15;
}

}  // namespace wander
