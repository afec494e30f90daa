#include "draw/figure/film_layout.h"

#include <algorithm>
#include <cmath>

#include "draw/figure/block.h"
#include "draw/figure/scene_inset.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double inset_width = 158, inset_gap = 10;
// Narrower pages have the drawing of the scene above the panels.
constexpr double least_width_beside = 400, most_inset_above = 84;
constexpr double header_gap = 3.5, header_line = 8.5, panel_gap = 5, right_room = 8;
constexpr double usual_labels = 22, least_bar = 0.8;

double width_of(const FilmFigureOptions& options) {
  return options.width.value_or(options.inset ? style::page_width : style::column_width);
}

bool is_beside(const FilmFigureOptions& options) {
  return options.inset && width_of(options) >= least_width_beside;
}

double indent_of(const FilmFigureOptions& options) {
  return is_beside(options) ? inset_width + inset_gap : 0;
}

void place_rows(FilmPage& page, const FilmContent& content) {
  if (content.header_lines == 0) {
    page.rows = {{page.top + overlay_height, page.top}};
    return;
  }
  const double header = header_gap + header_line * static_cast<double>(content.header_lines);
  double y = page.top;
  for (std::size_t k = 0; k < content.rows; ++k) {
    y += header;
    page.rows.push_back({y + panel_height, y});
    y += panel_height + panel_gap;
  }
}

void place_inset_beside(FilmPage& page, const description::Scene& scene) {
  const double room = page.rows.back().low - page.top + bottom_axis_height;
  page.inset_size = {inset_width, inset_height(scene, inset_width, room)};
  page.inset = {style::margin, page.top + (room - page.inset_size.y) / 2};
}

// From a crossing of two step lines to the next.
class Crossings {
 public:
  void at(double x, double difference) {
    constexpr double visible = 0.75, near = 4.5;
    if (std::abs(difference) < visible) return;
    const bool crossed = side_ * difference < 0;
    side_ = difference;
    if (!crossed) return;
    if (x - last_ < near) ++tangles_;
    last_ = x;
  }
  std::size_t tangles() const { return tangles_; }

 private:
  double side_ = 0, last_ = -INFINITY;
  std::size_t tangles_ = 0;
};

}  // namespace

std::size_t tangles(std::span<const Bar> a, std::span<const Bar> b, const Panel& panel) {
  Crossings crossings;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double left = std::max(a[i].position.low, b[j].position.low);
    const double right = std::min(a[i].position.high, b[j].position.high);
    if (left < right)
      crossings.at(panel.x(left), panel.height(b[j].value) - panel.height(a[i].value));
    if (a[i].position.high <= right)
      ++i;
    else
      ++j;
  }
  return crossings.tangles();
}

Layout best_layout(std::span<const Trace> traces, const Panel& panel) {
  constexpr std::size_t bearable = 8;
  if (traces.size() > 2) return Layout::panels;
  if (traces.size() < 2) return Layout::overlay;
  return tangles(traces[0].bars, traces[1].bars, panel) <= bearable ? Layout::overlay
                                                                    : Layout::panels;
}

double panel_room(const FilmFigureOptions& options) {
  return block_width(width_of(options)) - indent_of(options) - left_axis_gap - right_room;
}

std::size_t bars_in(const FilmFigureOptions& options) {
  return std::min(most_bars,
                  static_cast<std::size_t>((panel_room(options) - usual_labels) / least_bar));
}

FilmPage lay_out(const FilmContent& content, const FilmFigureOptions& options) {
  FilmPage page{};
  const double width = width_of(options);
  page.header_line = header_line;
  page.top = style::margin + std::max(4., title_height(options.title, block_width(width)) + 2.5);
  page.x = {style::margin + indent_of(options) + left_axis_gap + content.value_labels,
            width - style::margin - right_room};
  const bool above = options.inset && !is_beside(options);
  if (above) {
    page.inset_size = {inset_width, inset_height(*options.inset, inset_width, most_inset_above)};
    page.inset = {(width - inset_width) / 2, page.top};
    page.top += page.inset_size.y + inset_gap;
  }
  place_rows(page, content);
  if (is_beside(options)) place_inset_beside(page, *options.inset);
  // A single column is narrow: there the legend begins left of the axis.
  page.legend = {is_beside(options) ? page.x.low : style::margin + 6, width - style::margin};
  page.legend_top = page.rows.back().low + bottom_axis_height + 3;
  page.size = {width, page.legend_top + content.legend_height(page.legend.width()) + style::margin};
  return page;
}

}  // namespace wander::figure
