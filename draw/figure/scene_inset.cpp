#include "draw/figure/scene_inset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/figure/axis.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/style.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

// Around the drawing, for marks that stand out of it; below it, for the scale bar.
constexpr double padding = 7, bar_height = 16;

// The longest of 1, 2, 5 times a power of ten that is at most this long.
double nice_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most))), mantissa = most / power;
  return (mantissa < 2 ? 1 : mantissa < 5 ? 2 : 5) * power;
}

void draw_scale_bar(Svg& svg, const PageMap& map, Vector bottom_left, double most_points) {
  const double metres = nice_length(most_points / map.scale);
  const Vector left = bottom_left + Vector{0, 9}, right = left + Vector{metres * map.scale, 0};
  const auto scope = svg.group("scale");
  for (const Vector end : {left, right})
    svg.line(end - Vector{0, 1.5}, end + Vector{0, 1.5},
             {{"stroke", style::ink}, {"stroke-width", 0.6}});
  svg.line(left, right, {{"stroke", style::ink}, {"stroke-width", 0.6}});
  svg.text(right + Vector{4, 0.36 * style::small_size}, length_in_words(metres),
           {.size = style::small_size});
}

}  // namespace

std::string length_in_words(double metres) {
  constexpr std::array<std::string_view, 9> prefixes{"p", "n", "µ", "m", "", "k", "M", "G", "T"};
  if (metres >= 0.01 && metres < 1000) return number_text(metres, 4) + " m";
  const double power = std::floor(std::log10(metres) / 3 + 1e-9);
  if (!(power >= -4 && power <= 4)) return number_text(metres) + " m";
  const auto index = static_cast<std::size_t>(power + 4);
  return fmt::format("{} {}m", number_text(metres / std::pow(1000, power), 4), prefixes[index]);
}

double inset_height(const description::Scene& scene, double width, double most_height) {
  const Vector size = extent_of(scene).size();
  const double drawing = (width - 2 * padding) * size.y / size.x;
  return std::min(most_height, drawing + 2 * padding + bar_height);
}

void draw_inset(Svg& svg, const description::Scene& scene, Vector top_left, Vector size) {
  const Extent extent = extent_of(scene);
  const Vector low = top_left + Vector{padding, padding};
  const Vector high = top_left + size - Vector{padding, padding + bar_height};
  const PageMap map = fit(extent, low, high);
  const auto scope = svg.group("inset");
  draw_scene(svg, scene, map);
  draw_scale_bar(svg, map, map(extent.low) + Vector{0, padding - 2}, 0.4 * (high.x - low.x));
}

}  // namespace wander::figure
