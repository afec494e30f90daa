// Which parts of images are worth a closer look: squares in which the contenders differ most, by
// what is seen of their films beside the reference at the common exposure.
#pragma once

#include <span>
#include <vector>

#include "core/film_estimate.h"

namespace wander::report {

struct Crop {
  std::size_t x = 0, y = 0, side = 0;  // in pixels, from the top left corner
};

// Of a square m_k is the mean square of the difference of film k and the reference as they are
// shown (records/tone.h).  The best has the largest max m_k - min m_k, or max m_k of a single film;
// none overlap.  All films have the shape of the reference.
std::vector<Crop> choose_crops(std::span<const FilmEstimate* const> films,
                               const FilmEstimate& reference, double white, std::size_t most);

// That part of an image.
FilmEstimate cropped(const FilmEstimate& image, const Crop& crop);

}  // namespace wander::report
