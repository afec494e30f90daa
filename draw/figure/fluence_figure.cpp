#include "draw/figure/fluence_figure.h"

#include <fmt/format.h>

#include "draw/figure/marks.h"
#include "draw/figure/on_dark.h"
#include "draw/figure/plane_picture.h"
#include "draw/figure/scene_legend.h"
#include "lab/wording.h"

namespace wander::figure {
namespace {

constexpr double most_height = 420;

Block legend_block(const description::Scene& scene, double width) {
  const std::vector<LegendEntry> entries = legend_of(scene);
  constexpr double inset = 8;
  const double height = legend_height(entries, width - 2 * inset) + 2 * inset;
  return {"", height, [=](Svg& svg, Vector top_left) {
            define_on_dark(svg);
            svg.element("rect", {{"x", top_left.x},
                                 {"y", top_left.y},
                                 {"width", width},
                                 {"height", height},
                                 {"rx", 3},
                                 {"fill", dark_ground}});
            const auto scope = svg.group(on_dark);
            define_patterns(svg);
            draw_legend(svg, entries, top_left + Vector{inset, inset}, width - 2 * inset);
          }};
}

}  // namespace

std::string fluence_figure(const description::Scene& scene, const PlaneGrid& grid,
                           const Rendering& picture, const std::string& title, double page_width) {
  const double width = block_width(page_width);
  const std::string text = fmt::format("fluence of {}: {} of light", scene.name,
                                       counted_in_words(picture.samples, "walk"));
  const Block light = picture_block(
      {scene, grid, picture.film.value, {"fluence", "W/m"}, light_colours(), Ground::dark}, width,
      most_height);
  return page(title, text, page_width, {light, legend_block(scene, width)});
}

}  // namespace wander::figure
