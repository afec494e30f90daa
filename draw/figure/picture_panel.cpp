#include "draw/figure/picture_panel.h"

#include <utility>

#include "core/image_shape.h"
#include "records/tone.h"

namespace wander::figure {

ImagePanel picture_panel(std::vector<std::string> words, const FilmEstimate& image,
                         const Quantity& quantity, double white) {
  const FilmEstimate shown = averaged(image);
  const ImageShape size(shown.shape);
  std::vector<std::uint8_t> greys;
  for (int k = 0; k < 256; ++k)
    greys.insert(greys.end(), 3, srgb_byte(static_cast<double>(k) / 255));
  const Quantity scale{(size.channels > 1 ? "luminance of " : "") + quantity.name, quantity.unit};
  return {std::move(words),
          picture_png(srgb_bytes(shown.value, white), size.width, size.height, size.channels),
          static_cast<double>(image.shape[0]) / image.shape[1], greys, [=](Range page) {
            return make_axis(scale, {0, white}, page, ticks_in(page, 34));
          }};
}

}  // namespace wander::figure
