// Maps of errors and differences as panels of a figure, with the scales of their colours.
#pragma once

#include <string>
#include <vector>

#include "draw/figure/image_panel.h"
#include "draw/figure/tones.h"

namespace wander::figure {

// On a logarithmic scale.
ImagePanel log_panel(std::vector<std::string> words, const PixelMap& map, const ToneScale& scale,
                     const Quantity& quantity);

// Of differences in units of their error, from -most to most.
ImagePanel difference_panel(std::vector<std::string> words, const PixelMap& map, double most);
// Of shares of a whole.
ImagePanel share_panel(std::vector<std::string> words, const PixelMap& map);
// Wide enough for all but few of them, and for what chance makes of agreement.
double largest_shown(const std::vector<PixelMap>& differences);

}  // namespace wander::figure
