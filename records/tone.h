// How a film is shown: linear light as 8 bits of sRGB.
//
//   byte = round(255 · sRGB(clamp(2^EV · x / white, 0, 1)))
//   sRGB(v) = 12.92 v                      up to 0.0031308
//           = 1.055 v^(1/2.4) - 0.055      above
//
// `white` is the luminance that 99 % of the pixels with light do not exceed, and EV the exposure in
// stops, 0 unless someone says otherwise.  What is no number is black.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// Of an image; 1 if there is no light in it.
double white_of(const FilmEstimate& film);

std::uint8_t srgb_byte(double level);

// Every number of a film by itself.
std::vector<std::uint8_t> srgb_bytes(std::span<const double> values, double white);

// `film.png`, a quick look at an image: grey, or red, green and blue.
std::string film_png(const FilmEstimate& film, double exposure);

}  // namespace wander
