// An image as it looks, as a panel of a figure.
#pragma once

#include <string>
#include <vector>

#include "core/film_estimate.h"
#include "draw/figure/image_panel.h"

namespace wander::figure {

// `white` is the radiance that is drawn as white (records/tone.h).
ImagePanel picture_panel(std::vector<std::string> words, const FilmEstimate& image,
                         const Quantity& quantity, double white);

}  // namespace wander::figure
