#include "core/texture.h"

#include <algorithm>
#include <cmath>

namespace wander {

namespace {

// The two texels on either side of a coordinate, and how far it is from the first to the second.
struct Between {
  int first, second;
  double share;
};

Between between(double coordinate, int size) {
  const double turns = coordinate - std::floor(coordinate);
  const double place = (std::isfinite(turns) ? turns : 0) * size - 0.5;
  const double whole = std::floor(place);
  const int first = static_cast<int>(whole);
  return {(first + size) % size, (first + 1) % size, place - whole};
}

// Exact where both are equal.
double mixed(double a, double b, double share) { return a + share * (b - a); }

}  // namespace

Texture::Texture(Picture picture) : picture_(std::move(picture)) {
  const auto channels = static_cast<std::size_t>(picture_.channels);
  const auto add = [&](const auto& texels) {
    for (std::size_t i = 0; i < texels.size(); ++i)
      mean_[i % channels] += picture_.meaning[texels[i]];
  };
  add(picture_.bytes);
  add(picture_.words);
  for (double& channel : mean_)
    channel /= static_cast<double>(picture_.width) * static_cast<double>(picture_.height);
  if (channels == 1) mean_[1] = mean_[2] = mean_[0];
}

double Texture::texel(int x, int y, int channel) const {
  const auto& [width, height, channels, bytes, words, meaning] = picture_;
  const auto row = static_cast<std::size_t>(y), rows = static_cast<std::size_t>(width);
  const std::size_t i =
      (row * rows + static_cast<std::size_t>(x)) * static_cast<std::size_t>(channels) +
      static_cast<std::size_t>(channel);
  return meaning[bytes.empty() ? words[i] : bytes[i]];
}

std::array<double, 3> Texture::at(std::array<double, 2> uv) const {
  const Between x = between(uv[0], picture_.width), y = between(1 - uv[1], picture_.height);
  std::array<double, 3> colour{};
  for (int k = 0; k < picture_.channels; ++k)
    colour[static_cast<std::size_t>(k)] =
        mixed(mixed(texel(x.first, y.first, k), texel(x.second, y.first, k), x.share),
              mixed(texel(x.first, y.second, k), texel(x.second, y.second, k), x.share), y.share);
  if (picture_.channels == 1) colour[1] = colour[2] = colour[0];
  return colour;
}

}  // namespace wander
