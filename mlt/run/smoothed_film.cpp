#include "mlt/run/smoothed_film.h"

#include <algorithm>

namespace wander {

namespace {

using Film = std::vector<double>;

constexpr int smoothing_radius = 2;  // bins

// The smoothing along one axis, of so many bins that lie `stride` apart: Σ instead of the mean.
Film summed_along(const Film& film, int extent, std::size_t stride) {
  Film sums(film.size());
  for (std::size_t j = 0; j < film.size(); ++j) {
    const int at = static_cast<int>(j / stride % static_cast<std::size_t>(extent));
    const int low = std::max(0, at - smoothing_radius);
    const int high = std::min(extent - 1, at + smoothing_radius);
    const std::size_t begin = j - static_cast<std::size_t>(at - low) * stride;
    for (int i = low; i <= high; ++i)
      sums[j] += film[begin + static_cast<std::size_t>(i - low) * stride];
  }
  return sums;
}

}  // namespace

std::vector<double> smoothed(const std::vector<double>& film, std::span<const int> shape) {
  Film sums = film, counts(film.size(), 1.0);
  std::size_t stride = 1;
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    sums = summed_along(sums, shape[axis], stride);
    counts = summed_along(counts, shape[axis], stride);
    stride *= static_cast<std::size_t>(shape[axis]);
  }
  for (std::size_t j = 0; j < sums.size(); ++j) sums[j] /= counts[j];
  return sums;
}

}  // namespace wander
