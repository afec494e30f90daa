#include "draw/report/contender_image.h"

#include <algorithm>
#include <cmath>

#include "core/film_statistics.h"
#include "core/image_shape.h"
#include "core/tint.h"

namespace wander::report {
namespace {

using Films = std::vector<const Run*>;

figure::PixelMap map_over(const ImageShape& shape) {
  return {shape.width, shape.height, std::vector<double>(shape.pixels(), not_known)};
}

double squared(double x) { return x * x; }

double luminance_at(const FilmEstimate& film, const std::vector<double>& numbers, std::size_t p) {
  const int channels = channels_of(film.shape);
  double sum = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
    sum += luminance_weight(channels, c) * numbers[p * static_cast<std::size_t>(channels) + c];
  return sum;
}

// Squares are formed in units of the mean, for films may be very bright or dark.
double mean_of(const FilmEstimate& reference) {
  const double mean = std::abs(mean_value(reference));
  return mean > 0 && std::isfinite(mean) ? mean : 1;
}

figure::PixelMap error_map(const Films& runs, const FilmEstimate& reference) {
  const ImageShape shape(reference.shape);
  const double unit = mean_of(reference);
  figure::PixelMap map = map_over(shape);
  for (std::size_t p = 0; p < shape.pixels(); ++p) {
    double square = 0, own = 0, size = 0;
    for (std::size_t i = p * shape.channels; i < (p + 1) * shape.channels; ++i) {
      for (const Run* run : runs)
        square += squared((run->film.value[i] - reference.value[i]) / unit) /
                  static_cast<double>(runs.size());
      if (std::isfinite(reference.standard_error[i]))
        own += squared(reference.standard_error[i] / unit);
      size += squared(reference.value[i] / unit) + squared(0.01);
    }
    // Else less than the reference knows; what it knows exactly, such as a void, may be right.
    if (square > own || own == 0) map.values[p] = std::sqrt((square - own) / size);
  }
  return map;
}

figure::PixelMap z_map(const Films& runs, const FilmEstimate& reference) {
  const ImageShape shape(reference.shape);
  figure::PixelMap map = map_over(shape);
  const auto count = static_cast<double>(runs.size());
  if (runs.size() < 2) return map;
  const double unit = mean_of(reference);
  for (std::size_t p = 0; p < shape.pixels(); ++p) {
    double mean = 0, spread = 0;
    for (const Run* run : runs) mean += luminance_at(run->film, run->film.value, p) / unit / count;
    for (const Run* run : runs)
      spread += squared(luminance_at(run->film, run->film.value, p) / unit - mean) / (count - 1);
    const double own = luminance_at(reference, reference.standard_error, p) / unit;
    const double error = std::sqrt(spread / count + (std::isfinite(own) ? squared(own) : 0));
    const double difference = mean - luminance_at(reference, reference.value, p) / unit;
    if (error > 0 && std::isfinite(difference)) map.values[p] = difference / error;
    if (difference == 0) map.values[p] = 0;
  }
  return map;
}

}  // namespace

std::optional<ContenderImage> image_of(const Subject& subject, std::size_t contender) {
  const FilmEstimate& reference = subject.runs().reference.film;
  const WholeReplicates whole(subject, contender, subject.comparison.decisive);
  Films runs = whole.runs();
  std::erase_if(runs, [&](const Run* run) { return run->film.shape != reference.shape; });
  if (runs.empty()) return std::nullopt;
  return ContenderImage{contender, *runs.front(), runs.size(), error_map(runs, reference),
                        z_map(runs, reference)};
}

}  // namespace wander::report
