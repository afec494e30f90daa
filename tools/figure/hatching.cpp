#include "tools/figure/hatching.h"

#include <fmt/format.h>

#include <array>

#include "tools/figure/style.h"

namespace wander::figure {
namespace {

enum class Mark { line, cross, dot };

struct Hatch {
  Mark mark;
  double spacing, angle, weight;
  std::string_view colour, ground;
};

constexpr std::string_view grey = "#5a5a5a";
constexpr std::array<Hatch, 11> hatches{{
    {Mark::line, 3, 45, 1.3, style::rejected.colour, "#fdebd3"},
    {Mark::line, 2.4, -45, 0.6, grey, style::paper},
    {Mark::dot, 2.6, 0, 0.6, grey, style::paper},
    {Mark::line, 2.4, 0, 0.7, grey, "#e9e9e9"},
    {Mark::cross, 3, 45, 0.5, grey, style::paper},
    {Mark::line, 3.4, 90, 1.4, "#8c8c8c", style::paper},
    {Mark::dot, 3.4, 45, 1, "#8c8c8c", "#efefef"},
    {Mark::cross, 2.6, 0, 0.5, grey, "#e4e4e4"},
    {Mark::line, 4.4, -45, 1.6, "#a8a8a8", style::paper},
    {Mark::line, 1.6, 90, 0.4, grey, style::paper},
    {Mark::cross, 4.6, 45, 0.9, grey, "#f4f4f4"},
}};

void draw_mark(Svg& svg, const Hatch& hatch) {
  const double middle = hatch.spacing / 2;
  if (hatch.mark == Mark::dot) {
    svg.element("circle",
                {{"cx", middle}, {"cy", middle}, {"r", hatch.weight}, {"fill", hatch.colour}});
    return;
  }
  const auto line = [&](Vector from, Vector to) {
    svg.line(from, to, {{"stroke", hatch.colour}, {"stroke-width", hatch.weight}});
  };
  line({0, middle}, {hatch.spacing, middle});
  if (hatch.mark == Mark::cross) line({middle, 0}, {middle, hatch.spacing});
}

}  // namespace

std::string define_hatch(Svg& svg, std::size_t k) {
  const std::size_t index = k < hatches.size() ? k : 1 + (k - 1) % (hatches.size() - 1);
  const Hatch& hatch = hatches[index];
  const std::string id = fmt::format("hatch-{}", index);
  if (svg.is_new(id)) {
    const auto definitions = svg.open("defs", {});
    const auto pattern =
        svg.open("pattern", {{"id", id},
                             {"patternUnits", "userSpaceOnUse"},
                             {"width", hatch.spacing},
                             {"height", hatch.spacing},
                             {"patternTransform", fmt::format("rotate({})", hatch.angle)}});
    svg.element("rect",
                {{"width", hatch.spacing}, {"height", hatch.spacing}, {"fill", hatch.ground}});
    draw_mark(svg, hatch);
  }
  return fmt::format("url(#{})", id);
}

}  // namespace wander::figure
