#include "draw/figure/hatching.h"

#include <fmt/format.h>

#include <array>

#include "draw/figure/style.h"

namespace wander::figure {
namespace {

std::string_view name_of(Tile tile) {
  constexpr std::array<std::string_view, 10> names{"plain", "line",   "dash",     "cross",  "dot",
                                                   "ring",  "square", "triangle", "zigzag", "plus"};
  return names[static_cast<std::size_t>(tile)];
}

// Patterns are named after all that they are made of, so that equal names are equal patterns.
std::string id_of(const Fill& fill) {
  std::string id = fmt::format("fill-{}-{}-{}-{}", name_of(fill.tile), number(fill.spacing),
                               number(fill.angle), number(fill.weight));
  for (const std::string_view colour : {fill.colour, fill.ground})
    if (!colour.empty()) id += fmt::format("-{}", colour.substr(1));
  return id;
}

void stroke(Svg& svg, const Fill& fill, const std::string& data) {
  svg.path(data, {{"stroke", fill.colour}, {"stroke-width", fill.weight}, {"fill", "none"}});
}

void solid(Svg& svg, const Fill& fill, const std::string& data) {
  svg.path(data, {{"fill", fill.colour}});
}

void draw_tile(Svg& svg, const Fill& fill) {
  const double size = fill.spacing, middle = size / 2, radius = 0.27 * size;
  const std::string across = "M0 " + number(middle) + "H" + number(size);
  const std::string down = "M" + number(middle) + " 0V" + number(size);
  switch (fill.tile) {
    case Tile::plain:
      return;
    case Tile::line:
      return stroke(svg, fill, across);
    case Tile::dash:
      return stroke(svg, fill,
                    "M0 " + number(size / 4) + "h" + number(middle) + "M" + number(middle) + " " +
                        number(0.75 * size) + "h" + number(middle));
    case Tile::cross:
      return stroke(svg, fill, across + down);
    case Tile::dot:
      return svg.element(
          "circle", {{"cx", middle}, {"cy", middle}, {"r", fill.weight}, {"fill", fill.colour}});
    case Tile::ring:
      return svg.element("circle", {{"cx", middle},
                                    {"cy", middle},
                                    {"r", radius},
                                    {"fill", "none"},
                                    {"stroke", fill.colour},
                                    {"stroke-width", fill.weight}});
    case Tile::square:
      return svg.element("rect", {{"x", middle - radius},
                                  {"y", middle - radius},
                                  {"width", 2 * radius},
                                  {"height", 2 * radius},
                                  {"fill", fill.colour}});
    case Tile::triangle:
      return solid(svg, fill,
                   "M" + coordinates({middle, middle - radius}) + "l" +
                       coordinates({1.15 * radius, 2 * radius}) + "h" + number(-2.3 * radius) +
                       "Z");
    case Tile::zigzag:
      return stroke(svg, fill,
                    "M0 " + number(middle + radius) + "L" + coordinates({middle, middle - radius}) +
                        "L" + coordinates({size, middle + radius}));
    case Tile::plus:
      return stroke(svg, fill,
                    "M" + coordinates({middle - radius, middle}) + "h" + number(2 * radius) + "M" +
                        coordinates({middle, middle - radius}) + "v" + number(2 * radius));
  }
}

}  // namespace

std::string define_fill(Svg& svg, const Fill& fill) {
  if (fill.tile == Tile::plain) return std::string(fill.ground);
  const std::string id = id_of(fill);
  if (svg.is_new(id)) {
    const auto definitions = svg.open("defs", {});
    const auto pattern =
        svg.open("pattern", {{"id", id},
                             {"patternUnits", "userSpaceOnUse"},
                             {"width", fill.spacing},
                             {"height", fill.spacing},
                             {"patternTransform", fmt::format("rotate({})", number(fill.angle))}});
    if (!fill.ground.empty())
      svg.element("rect",
                  {{"width", fill.spacing}, {"height", fill.spacing}, {"fill", fill.ground}});
    draw_tile(svg, fill);
  }
  return fmt::format("url(#{})", id);
}

}  // namespace wander::figure
