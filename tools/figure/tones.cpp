#include "tools/figure/tones.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace wander::figure {
namespace {

// Share of the positive values above the scale: fireflies do not darken a picture.
constexpr double beyond = 0.002;
constexpr double least_decades = 1, most_decades = 3;
// In cells: neighbours overlap a little, so that no line of paper shows between them.
constexpr double overlap = 0.12;

std::string colour(const style::Shading& shading, int tone) {
  const double place = 2.0 * tone / (tone_count - 1);
  const std::size_t k = place < 1 ? 0 : 1;
  const double t = place - static_cast<double>(k);
  std::string text = "#";
  for (std::size_t c = 0; c < 3; ++c)
    text += fmt::format("{:02x}", static_cast<int>(std::lround((1 - t) * shading.anchors[k][c] +
                                                               t * shading.anchors[k + 1][c])));
  return text;
}

// The runs of cells of each tone as path data, in units of cells, y downwards.  A run begins where
// the one before it ended: moves are relative, hence short.
class Runs {
 public:
  void add(int tone, int row, int from, int to) {
    Pen& pen = pens_[static_cast<std::size_t>(tone)];
    pen.data += fmt::format("m{} {}h{}", from - pen.x, row - pen.y, to - from);
    pen.x = to;
    pen.y = row;
  }
  const std::string& data(int tone) const { return pens_[static_cast<std::size_t>(tone)].data; }

 private:
  struct Pen {
    std::string data;
    int x = 0, y = 0;
  };
  std::array<Pen, tone_count> pens_;
};

Runs runs_of(const std::vector<int>& tones, const PlaneGrid& grid, int background) {
  Runs runs;
  const int columns = grid.columns();
  for (int row = 0; row < grid.rows(); ++row)
    for (int from = 0, to = 0; from < columns; from = to) {
      const auto at = [&](int x) { return tones[static_cast<std::size_t>(row * columns + x)]; };
      for (to = from + 1; to < columns && at(to) == at(from);) ++to;
      if (at(from) != background) runs.add(at(from), row, from, to);
    }
  return runs;
}

int commonest(const std::vector<int>& tones) {
  std::array<std::size_t, tone_count> counts{};
  for (const int tone : tones) ++counts[static_cast<std::size_t>(tone)];
  return static_cast<int>(std::ranges::max_element(counts) - counts.begin());
}

void draw_background(Svg& svg, Vector low, Vector high, std::string_view fill) {
  svg.element("rect", {{"x", low.x},
                       {"y", high.y},
                       {"width", high.x - low.x},
                       {"height", low.y - high.y},
                       {"fill", fill}});
}

}  // namespace

int ToneScale::tone(double value) const {
  if (!(value > domain.low)) return 0;
  const double place = std::log(value / domain.low) / std::log(domain.high / domain.low);
  return static_cast<int>(std::min(place * tone_count, tone_count - 1.0));
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
                const ToneScale& scale, const style::Shading& shading, Vector low, Vector high) {
  std::vector<int> tones;
  for (const double value : values) tones.push_back(scale.tone(value));
  const int background = commonest(tones);
  const Runs runs = runs_of(tones, grid, background);
  const auto scope = svg.group("tones");
  draw_background(svg, low, high, colour(shading, background));
  const std::string place =
      fmt::format("translate({} {}) scale({:.6g} {:.6g})", number(low.x), number(high.y),
                  (high.x - low.x) / grid.columns(), (low.y - high.y) / grid.rows());
  const auto cells =
      svg.open("g", {{"transform", place}, {"fill", "none"}, {"stroke-width", 1 + overlap}});
  for (int tone = 0; tone < tone_count; ++tone)
    if (!runs.data(tone).empty())
      svg.path("M0 .5" + runs.data(tone), {{"stroke", colour(shading, tone)}});
}

void draw_tone_legend(Svg& svg, const ToneScale& scale, const style::Shading& shading,
                      const Quantity& quantity, Vector top_left, double width) {
  constexpr double bar_height = 8;
  const auto scope = svg.group("tone-legend");
  const double step = width / tone_count;
  for (int tone = 0; tone < tone_count; ++tone)
    svg.element("rect", {{"x", top_left.x + tone * step},
                         {"y", top_left.y},
                         {"width", step + (tone + 1 < tone_count ? 0.2 : 0)},
                         {"height", bar_height},
                         {"fill", colour(shading, tone)}});
  const Axis axis = make_log_axis(quantity, scale.domain, {top_left.x, top_left.x + width});
  draw_bottom_axis(svg, axis, top_left.y + bar_height);
  draw_bottom_title(svg, axis, top_left.y + bar_height);
}

}  // namespace wander::figure
