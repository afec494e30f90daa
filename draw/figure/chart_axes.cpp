#include "draw/figure/chart_axes.h"

#include <algorithm>
#include <cmath>

namespace wander::figure {
namespace {

constexpr double fewest_decades = 1;
constexpr Range most_decades{1e-307, 1e308};

// Within what a double can tell apart from zero and from infinity.
Range positive(Range range) {
  const double low = std::clamp(range.low, most_decades.low, most_decades.high / 10);
  const double high = std::clamp(range.high, 10 * most_decades.low, most_decades.high);
  return low < high ? Range{low, high} : Range{0.1, 1};
}

// The range of what is offered, as far as its axis can show it.
class Hull {
 public:
  explicit Hull(Spacing spacing) : spacing_(spacing) {}

  void include(double value) {
    if (!std::isfinite(value) || (spacing_ == Spacing::logarithmic && value <= 0)) return;
    range_ = {std::min(range_.low, value), std::max(range_.high, value)};
  }
  void include(const std::optional<Range>& interval) {
    if (!interval) return;
    include(interval->low);
    include(interval->high);
  }
  Range with_room() const {
    if (range_.low > range_.high)
      return spacing_ == Spacing::logarithmic ? Range{0.1, 1} : Range{0, 1};
    return spacing_ == Spacing::logarithmic ? logarithmic() : linear();
  }

 private:
  // Zero belongs to the axis where it is near.
  Range linear() const {
    const bool near_zero = range_.low >= 0 && range_.low < 0.6 * range_.high;
    const double low = near_zero ? 0 : range_.low, room = 0.05 * (range_.high - low);
    return usable({near_zero ? 0 : low - room, range_.high + room});
  }
  Range logarithmic() const {
    const double low = std::log10(range_.low), high = std::log10(range_.high);
    const double room = std::max(0.06 * (high - low), (fewest_decades - (high - low)) / 2);
    return {std::pow(10, low - room), std::pow(10, high + room)};
  }

  Spacing spacing_;
  Range range_{INFINITY, -INFINITY};
};

}  // namespace

bool ChartAxis::shows(double value) const {
  return std::isfinite(value) && (spacing != Spacing::logarithmic || value > 0);
}

double ChartAxis::operator()(double value) const {
  constexpr double beyond = 20;
  const double at = axis.scale(spacing == Spacing::logarithmic ? std::log10(value) : value);
  const auto [low, high] = std::minmax(axis.scale.page.low, axis.scale.page.high);
  return std::clamp(at, low - beyond, high + beyond);
}

Range x_range(const Chart& chart) {
  if (chart.x.range) return *chart.x.range;
  Hull hull(chart.x.spacing);
  for (const ChartPanel& panel : chart.panels)
    for (const Series& series : panel.series)
      for (const Point& point : series.points) {
        hull.include(point.x);
        hull.include(point.x_interval);
      }
  return hull.with_room();
}

Range y_range(const Chart& chart) {
  if (chart.y.range) return *chart.y.range;
  Hull hull(chart.y.spacing);
  for (const ChartPanel& panel : chart.panels) {
    for (const Series& series : panel.series)
      for (const Point& point : series.points) {
        hull.include(point.y);
        hull.include(point.y_interval);
      }
    for (const Guide& guide : panel.guides) hull.include(guide.at);
    hull.include(panel.band);
  }
  return hull.with_room();
}

ChartAxis chart_axis(const Dimension& dimension, Range range, Range page, int at_most_ticks) {
  if (dimension.spacing == Spacing::logarithmic)
    return {make_log_axis(dimension.quantity, positive(range), page), dimension.spacing};
  if (dimension.spacing == Spacing::whole)
    at_most_ticks = static_cast<int>(std::min<double>(at_most_ticks, range.width() + 1));
  return {make_axis(dimension.quantity, range, page, at_most_ticks), dimension.spacing};
}

}  // namespace wander::figure
