#include "draw/figure/space_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/figure/block.h"
#include "draw/figure/clip.h"
#include "draw/figure/legend.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/stage.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double greatest_height = 420, gap = 8;

std::string words_of(WireKind kind) {
  switch (kind) {
    case WireKind::surface:
      return "edges of surfaces, hidden ones too";
    case WireKind::glass:
      return "glass";
    case WireKind::light:
      return "light";
    case WireKind::sensor:
      return "sensor";
  }
  return "";
}

bool is_seen(const WireLine& line, const View& view) {
  const auto piece = view.line(line.from, line.to);
  const Extent extent = view.extent();
  return piece && !clipped({piece->from, piece->to}, {extent.low, extent.high}).empty();
}

std::vector<LegendEntry> legend_of(const std::vector<WireLine>& lines, const View& view) {
  std::vector<LegendEntry> entries;
  for (const WireKind kind :
       {WireKind::light, WireKind::sensor, WireKind::surface, WireKind::glass})
    if (std::ranges::any_of(
            lines, [&](const WireLine& line) { return line.kind == kind && is_seen(line, view); }))
      entries.push_back({[kind](Svg& svg, Vector left) {
                           draw_wire(svg, kind,
                                     "M" + coordinates(left) + "h" + number(swatch_width));
                         },
                         words_of(kind)});
  return entries;
}

std::string spoken(const description::Scene& scene, const SceneFaces& faces) {
  return fmt::format("The outline of a scene in space of {} faces, {}.", faces.size(),
                     scene.camera ? "as its camera sees it" : "seen from outside");
}

}  // namespace

View view_of(const description::Scene& scene, const SceneFaces& faces) {
  return scene.camera ? View(*scene.camera) : View(faces);
}

std::string space_figure(const description::Scene& scene, const SceneFigureOptions& options) {
  const SceneFaces faces = scene_faces(scene);
  const View view = view_of(scene, faces);
  const std::vector<WireLine> lines = wireframe(faces, view.eye());
  const std::vector<LegendEntry> entries = legend_of(lines, view);
  const double width = block_width(options.width);
  const double height = std::min(width * view.height(), greatest_height);
  const Stage stage = space_stage(view, lines);
  const double below = gap + legend_height(entries, width);
  const auto draw = [=](Svg& svg, Vector top_left) {
    stage.draw(svg, fit(stage.extent, top_left, top_left + Vector{width, height}));
    draw_legend(svg, entries, top_left + Vector{0, height + gap}, width);
  };
  return page(options.title.empty() ? scene.name : options.title, spoken(scene, faces),
              options.width, {{"", height + below, draw}});
}

}  // namespace wander::figure
