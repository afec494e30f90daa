#include "records/tone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/image_shape.h"
#include "core/tint.h"
#include "records/png.h"

namespace wander {

namespace {

constexpr double share_below_white = 0.99;

// Of the pixels that have light.
std::vector<double> luminances(const FilmEstimate& film) {
  const std::size_t channels = ImageShape(film.shape).channels;
  std::vector<double> all;
  for (std::size_t i = 0; i + channels <= film.value.size(); i += channels) {
    const double* const pixel = &film.value[i];
    const double y = channels == 1 ? pixel[0] : luminance(std::array{pixel[0], pixel[1], pixel[2]});
    if (y > 0 && std::isfinite(y)) all.push_back(y);
  }
  return all;
}

double srgb(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }

}  // namespace

double white_of(const FilmEstimate& film) {
  std::vector<double> light = luminances(film);
  if (light.empty()) return 1;
  const auto rank = std::ceil(share_below_white * static_cast<double>(light.size())) - 1;
  const auto at = light.begin() + static_cast<std::ptrdiff_t>(rank);
  std::ranges::nth_element(light, at);
  return *at;
}

std::uint8_t srgb_byte(double level) {
  if (!(level > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(255 * srgb(std::min(level, 1.))));
}

std::vector<std::uint8_t> srgb_bytes(std::span<const double> values, double white) {
  std::vector<std::uint8_t> bytes(values.size());
  std::ranges::transform(values, bytes.begin(),
                         [white](double value) { return srgb_byte(value / white); });
  return bytes;
}

std::string film_png(const FilmEstimate& film, double exposure) {
  const ImageShape shape(film.shape);
  const double white = white_of(film) / std::exp2(exposure);
  return to_png(srgb_bytes(film.value, white), static_cast<int>(shape.width),
                static_cast<int>(shape.height), static_cast<int>(shape.channels));
}

}  // namespace wander
