#include "tools/figure/fluence_figure.h"

#include <fmt/format.h>

#include "tools/figure/marks.h"
#include "tools/figure/plane_picture.h"
#include "tools/figure/scene_legend.h"
#include "tools/wording.h"

namespace wander::figure {
namespace {

constexpr double most_height = 420;

Block legend_block(const description::Scene& scene, double width) {
  const std::vector<LegendEntry> entries = legend_of(scene);
  const double indent = 8;
  return {"", legend_height(entries, width - indent), [=](Svg& svg, Vector top_left) {
            define_patterns(svg);
            draw_legend(svg, entries, top_left + Vector{indent, 0}, width - indent);
          }};
}

}  // namespace

std::string fluence_figure(const description::Scene& scene, const PlaneGrid& grid,
                           const Rendering& picture, const std::string& title, double page_width) {
  const double width = block_width(page_width);
  const std::string text = fmt::format("fluence of {}: {} walks of light", scene.name,
                                       count_in_words(static_cast<double>(picture.samples)));
  const Block light =
      picture_block({scene, grid, picture.film.value, {"fluence", "W/m"}, style::light_shading},
                    width, most_height);
  return page(title, text, page_width, {light, legend_block(scene, width)});
}

}  // namespace wander::figure
