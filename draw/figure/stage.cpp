#include "draw/figure/stage.h"

#include <utility>

#include "draw/figure/embedded_image.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

// So that black and coloured lines are seen on dark pictures too.
constexpr double veil = 0.45;

void rectangle(Svg& svg, Vector top_left, Vector size, std::string_view fill, double opacity,
               std::string_view stroke) {
  svg.element("rect", {{"x", top_left.x},
                       {"y", top_left.y},
                       {"width", size.x},
                       {"height", size.y},
                       {"fill", fill},
                       {"fill-opacity", opacity},
                       {"stroke", stroke},
                       {"stroke-width", 0.4}});
}

}  // namespace

Stage plane_stage(const description::Scene& scene) {
  return {extent_of(scene),
          [&scene](Svg& svg, const PageMap& map) { draw_scene(svg, scene, map); },
          {},
          &scene};
}

Stage space_stage(const View& view, std::vector<WireLine> outline, std::string picture) {
  const auto draw = [view, outline = std::move(outline), picture = std::move(picture)](
                        Svg& svg, const PageMap& map) {
    const Extent extent = view.extent();
    const Vector top_left = map({extent.low.x, extent.high.y});
    const Vector size = map({extent.high.x, extent.low.y}) - top_left;
    if (!picture.empty()) {
      draw_image(svg, picture, top_left, size);
      rectangle(svg, top_left, size, style::paper, veil, "none");
    }
    draw_wireframe(svg, outline, view, map);
    rectangle(svg, top_left, size, "none", 1, style::neutral.colour);
  };
  return {view.extent(), draw,
          [view](std::span<const double> coordinates) { return view.path(coordinates); }, nullptr};
}

}  // namespace wander::figure
