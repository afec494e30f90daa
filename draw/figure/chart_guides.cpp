#include "draw/figure/chart_guides.h"

#include <algorithm>

#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double guide_row = 9, least_room = 50;

// The lines of the labels of vertical guides stand one below the other, all on one side of their
// guides and in the order in which no guide crosses a label.
struct GuideLabels {
  struct Label {
    Guide guide;
    std::vector<std::string> lines;
  };
  std::vector<Label> labels{};
  bool right = true;

  double height() const {
    double rows = 0;
    for (const Label& label : labels) rows += static_cast<double>(label.lines.size());
    return guide_row * rows;
  }
};

GuideLabels guide_labels(const Chart& chart, const ChartAxis& x) {
  const Range page = x.axis.scale.page;
  std::vector<Guide> guides;
  for (const Guide& guide : chart.guides)
    if (x.shows(guide.at) && x(guide.at) >= page.low && x(guide.at) <= page.high)
      guides.push_back(guide);
  // The side on which the label that has the least room for its words has more.
  const auto shortage = [&](const auto& room) {
    double most = 0;
    for (const Guide& guide : guides)
      most = std::max(most, text_width(guide.label, style::small_size) - room(guide));
    return most;
  };
  const auto to_the_right = [&](const Guide& guide) { return page.high - x(guide.at) - 3; };
  const auto to_the_left = [&](const Guide& guide) { return x(guide.at) - page.low - 3; };
  GuideLabels result;
  result.right = shortage(to_the_right) <= shortage(to_the_left);
  std::ranges::sort(guides, {}, &Guide::at);
  if (!result.right) std::ranges::reverse(guides);
  for (const Guide& guide : guides)
    result.labels.push_back(
        {guide,
         wrapped(guide.label, style::small_size,
                 std::max(least_room, result.right ? to_the_right(guide) : to_the_left(guide)))});
  return result;
}

}  // namespace

void draw_guide(Svg& svg, Vector from, Vector to) {
  svg.line(from, to,
           {{"class", "guide"},
            {"stroke", style::guide.colour},
            {"stroke-width", 0.8},
            {"stroke-dasharray", style::guide.dashes}});
}

double guides_height(const Chart& chart, const ChartAxis& x) {
  return guide_labels(chart, x).height();
}

void draw_vertical_guides(Svg& svg, const Chart& chart, const ChartAxis& x, double top,
                          double bottom) {
  const auto [labels, right] = guide_labels(chart, x);
  for (const auto& [guide, lines] : labels) {
    const double at = x(guide.at);
    draw_guide(svg, {at, top + 3}, {at, bottom});
    for (const std::string& line : lines) {
      top += guide_row;
      svg.text({at + (right ? 3 : -3), top - 1}, line,
               {.size = style::small_size, .anchor = right ? "start" : "end"});
    }
  }
}

}  // namespace wander::figure
