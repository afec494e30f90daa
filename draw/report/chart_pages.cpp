#include "draw/report/chart_pages.h"

#include <algorithm>

#include "draw/figure/chart_axes.h"
#include "draw/figure/style.h"
#include "draw/report/embedding.h"

namespace wander::report {
namespace {

// No higher than half a page of paper, so that pages fill.
constexpr std::size_t panels_per_figure = 3;

}  // namespace

std::string chart_document(figure::Chart chart, const std::string& title,
                           const std::string& description, double width) {
  return figure::page(title, description, width,
                      {figure::chart_block(std::move(chart), figure::block_width(width))});
}

void write_panels(Html& html, const figure::Chart& chart, const std::string& title,
                  const std::string& description, const std::string& caption) {
  for (std::size_t first = 0; first < chart.panels.size(); first += panels_per_figure) {
    figure::Chart part = chart;
    const auto begin = chart.panels.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(panels_per_figure, chart.panels.size() - first);
    part.panels.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    // The same scale in every figure.
    part.y.range = figure::y_range(chart);
    write_figure(html, chart_document(std::move(part), title, description),
                 first == 0 ? caption : "Continued: the same for the next contenders.");
  }
}

}  // namespace wander::report
