#include "draw/figure/tones.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "draw/figure/embedded_image.h"

namespace wander::figure {
namespace {

// Share of the positive values above the scale: fireflies do not darken a picture.
constexpr double beyond = 0.002;
constexpr double least_decades = 1, most_decades = 3;

}  // namespace

std::uint8_t ToneScale::tone(double value) const {
  constexpr double count = std::tuple_size_v<ColourMap>;
  if (!(value > domain.low)) return 0;
  const double place = std::log(value / domain.low) / std::log(domain.high / domain.low);
  return static_cast<std::uint8_t>(std::min(place * count, count - 1));
}

ToneScale tone_scale(std::span<const double> values) {
  std::vector<double> positive;
  for (const double value : values)
    if (value > 0 && std::isfinite(value)) positive.push_back(value);
  if (positive.empty()) return {{0.1, 1}};
  std::ranges::sort(positive);
  const auto quantile = [&](double share) {
    return positive[static_cast<std::size_t>(share * static_cast<double>(positive.size() - 1))];
  };
  // Some room above, so that an even picture is not all of the last tone.
  const double high = 1.1 * quantile(1 - beyond);
  const double decades =
      std::clamp(std::log10(high / quantile(beyond)), least_decades, most_decades);
  return {{high / std::pow(10, decades), high}};
}

void draw_tones(Svg& svg, std::span<const double> values, const PlaneGrid& grid,
                const ToneScale& scale, const ColourMap& colours, Vector low, Vector high) {
  std::vector<std::uint8_t> tones;
  for (const double value : values) tones.push_back(scale.tone(value));
  const auto scope = svg.group("tones");
  draw_image(svg, to_png(tones, grid.columns(), grid.rows(), colours), {low.x, high.y},
             {high.x - low.x, low.y - high.y});
}

void draw_tone_legend(Svg& svg, const ToneScale& scale, const ColourMap& colours,
                      const Quantity& quantity, Vector top_left, double width) {
  constexpr double bar_height = 8;
  const auto scope = svg.group("tone-legend");
  std::vector<std::uint8_t> tones(colours.size());
  std::iota(tones.begin(), tones.end(), std::uint8_t{0});
  draw_image(svg, to_png(tones, static_cast<int>(tones.size()), 1, colours), top_left,
             {width, bar_height});
  const Axis axis = make_log_axis(quantity, scale.domain, {top_left.x, top_left.x + width});
  draw_bottom_axis(svg, axis, top_left.y + bar_height);
  draw_bottom_title(svg, axis, top_left.y + bar_height);
}

}  // namespace wander::figure
