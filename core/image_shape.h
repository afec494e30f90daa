// The extents of a film: {bins} in the plane, {height, width} of an image, {height, width, 3} of one
// in colour.  Numbers go from channel to channel of a pixel, along a row, and from row to row from
// the top.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

namespace wander {

// Else a row of bins.
inline bool is_image(std::span<const int> film_shape) { return film_shape.size() > 1; }

struct ImageShape {
  std::size_t height = 1, width = 0, channels = 1;

  ImageShape() = default;
  explicit ImageShape(std::span<const int> film) {
    if (film.empty()) return;
    if (film.size() > 3 || (film.size() == 3 && film[2] != 1 && film[2] != 3))
      throw std::invalid_argument("no film has this shape");
    width = static_cast<std::size_t>(film.size() == 1 ? film[0] : film[1]);
    if (film.size() > 1) height = static_cast<std::size_t>(film[0]);
    if (film.size() > 2) channels = static_cast<std::size_t>(film[2]);
  }

  std::size_t pixels() const { return height * width; }
  std::size_t numbers() const { return pixels() * channels; }
};

}  // namespace wander
