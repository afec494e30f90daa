// What figures show of an image, as one number for each pixel.
//
// An image in colour counts by its luminance, whose standard error is at most the sum of those of
// its channels in their shares; this is what is shown, since how they go together is not kept.
#pragma once

#include <cstddef>
#include <vector>

#include "core/film_estimate.h"

namespace wander::figure {

struct PixelMap {
  std::size_t width = 0, height = 0;
  std::vector<double> values;  // rows from the top; NaN: not known
};

// Standard error over value.
PixelMap relative_error_map(const FilmEstimate& image);

// z = (value - value of the other) / error of both; not known where one of them is not reliable.
PixelMap difference_map(const FilmEstimate& image, const FilmEstimate& other);

// What of a map or an image a figure can show: every n-th pixel of every n-th row.
std::size_t pixels_per_pixel(std::size_t width, std::size_t height);
PixelMap thinned(const PixelMap& map, std::size_t n);
PixelMap thinned(const PixelMap& map);
// An image is averaged over these squares; at its edges, over what there is of them.
FilmEstimate averaged(const FilmEstimate& image, std::size_t n);
FilmEstimate averaged(const FilmEstimate& image);

}  // namespace wander::figure
