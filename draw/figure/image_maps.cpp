#include "draw/figure/image_maps.h"

#include <algorithm>
#include <cmath>

#include "core/image_shape.h"
#include "core/tint.h"

namespace wander::figure {
namespace {

// Of the longer side; the width of a page has not many more dots.
constexpr std::size_t most_across = 1024;

template <class Number>
PixelMap map_of(const FilmEstimate& image, Number&& number) {
  const ImageShape shape(image.shape);
  PixelMap map{shape.width, shape.height, std::vector<double>(shape.pixels())};
  for (std::size_t p = 0; p < map.values.size(); ++p) map.values[p] = number(p);
  return map;
}

// Of a quantity that has a number for each channel.
double luminance_at(const FilmEstimate& image, const std::vector<double>& numbers, std::size_t p) {
  const int channels = channels_of(image.shape);
  const auto count = static_cast<std::size_t>(channels);
  double sum = 0;
  for (std::size_t c = 0; c < count; ++c)
    sum += luminance_weight(channels, c) * numbers[p * count + c];
  return sum;
}

bool is_reliable(const FilmEstimate& image, std::size_t p) {
  const auto channels = static_cast<std::size_t>(channels_of(image.shape));
  for (std::size_t c = 0; c < channels; ++c)
    if (!image.reliable.empty() && !image.reliable[p * channels + c]) return false;
  return true;
}

// What is not finite is not known.
double quotient(double dividend, double divisor) {
  const double q = dividend / divisor;
  return std::isfinite(q) ? q : not_known;
}

}  // namespace

PixelMap relative_error_map(const FilmEstimate& image) {
  return map_of(image, [&](std::size_t p) {
    return quotient(luminance_at(image, image.standard_error, p),
                    luminance_at(image, image.value, p));
  });
}

PixelMap difference_map(const FilmEstimate& image, const FilmEstimate& other) {
  std::vector<double> error(image.value.size());
  for (std::size_t i = 0; i < error.size(); ++i)
    error[i] = std::hypot(image.standard_error[i], other.standard_error[i]);
  return map_of(image, [&](std::size_t p) {
    if (!is_reliable(image, p) || !is_reliable(other, p)) return not_known;
    const double difference =
        luminance_at(image, image.value, p) - luminance_at(other, other.value, p);
    return difference == 0 ? 0 : quotient(difference, luminance_at(image, error, p));
  });
}

std::size_t pixels_per_pixel(std::size_t width, std::size_t height) {
  return (std::max(width, height) + most_across - 1) / most_across;
}

PixelMap thinned(const PixelMap& map) {
  return thinned(map, pixels_per_pixel(map.width, map.height));
}

PixelMap thinned(const PixelMap& map, std::size_t n) {
  PixelMap few{(map.width + n - 1) / n, (map.height + n - 1) / n, {}};
  for (std::size_t y = 0; y < map.height; y += n)
    for (std::size_t x = 0; x < map.width; x += n)
      few.values.push_back(map.values[y * map.width + x]);
  return few;
}

FilmEstimate averaged(const FilmEstimate& image) {
  const ImageShape shape(image.shape);
  return averaged(image, pixels_per_pixel(shape.width, shape.height));
}

FilmEstimate averaged(const FilmEstimate& image, std::size_t n) {
  const ImageShape shape(image.shape);
  const std::size_t channels = shape.channels;
  const std::size_t width = (shape.width + n - 1) / n, height = (shape.height + n - 1) / n;
  FilmEstimate few{.shape = image.shape};
  few.shape[0] = static_cast<int>(height);
  few.shape[1] = static_cast<int>(width);
  few.value.resize(width * height * channels);
  for (std::size_t y = 0; y < shape.height; ++y)
    for (std::size_t x = 0; x < shape.width; ++x)
      for (std::size_t c = 0; c < channels; ++c)
        few.value[(y / n * width + x / n) * channels + c] +=
            image.value[(y * shape.width + x) * channels + c];
  const auto in_square = [n](std::size_t at, std::size_t end) { return std::min(n, end - at * n); };
  for (std::size_t i = 0; i < few.value.size(); ++i) {
    const std::size_t x = i / channels % width, y = i / channels / width;
    few.value[i] /= static_cast<double>(in_square(x, shape.width) * in_square(y, shape.height));
  }
  return few;
}

}  // namespace wander::figure
