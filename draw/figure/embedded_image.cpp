#include "draw/figure/embedded_image.h"

#include "records/png.h"

namespace wander::figure {

void draw_image(Svg& svg, const std::string& png, Vector top_left, Vector size) {
  svg.element("image",
              {{"x", top_left.x},
               {"y", top_left.y},
               {"width", size.x},
               {"height", size.y},
               {"preserveAspectRatio", "none"},
               // Inkscape 1.2 knows xlink:href alone, and the bytes are too many to be said twice.
               {"xlink:href", png_address(png)}});
}

}  // namespace wander::figure
