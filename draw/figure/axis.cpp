#include "draw/figure/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/figure/scale_of_ten.h"
#include "draw/figure/style.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

constexpr double tick_length = 3;
constexpr int exact_digits = 15;

double largest_magnitude(Range range) {
  return std::max(std::abs(range.low), std::abs(range.high));
}

struct Step {
  int mantissa = 1, exponent = 0;

  double value() const { return decimal(mantissa, exponent); }
  double multiple(double k) const { return decimal(k * mantissa, exponent); }
  Step next() const {
    if (mantissa == 1) return {2, exponent};
    if (mantissa == 2) return {5, exponent};
    return {1, exponent + 1};
  }
};

// Tolerance in steps, for ends that are ticks up to rounding.
constexpr double slack = 1e-6;
double first_multiple(Range range, Step step) {
  return std::ceil(range.low / step.value() - slack);
}
double last_multiple(Range range, Step step) {
  return std::floor(range.high / step.value() + slack);
}

Step step_for(Range range, int at_most) {
  const double least = range.width() / std::max(at_most, 2);
  Step step{1, static_cast<int>(std::floor(std::log10(least)))};
  while (last_multiple(range, step) - first_multiple(range, step) + 1 > std::max(at_most, 2))
    step = step.next();
  return step;
}

std::string with_minus_sign(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, "−");
  return text;
}

std::string axis_title(const Quantity& quantity, double offset, int exponent) {
  std::string title = quantity.name;
  if (offset != 0)
    title +=
        fmt::format(" {} {}", offset < 0 ? "+" : "−", number_text(std::abs(offset), exact_digits));
  if (exponent == 0 && quantity.unit.empty()) return title;
  title += ", ";
  if (exponent != 0) title += "10" + superscript(exponent);
  if (exponent != 0 && !quantity.unit.empty()) title += ' ';
  return title + quantity.unit;
}

void hairline(Svg& svg, Vector from, Vector to) {
  svg.line(from, to, {{"stroke", style::ink}, {"stroke-width", 0.6}});
}

}  // namespace

Range usable(Range range) {
  if (!std::isfinite(range.high) || !std::isfinite(range.width())) return {0, 1};
  if (range.low > range.high) std::swap(range.low, range.high);
  const double magnitude = largest_magnitude(range);
  if (magnitude < 1e-290) return {0, 1};
  // Each tick must remain a number of its own.
  if (range.width() > 1e-11 * magnitude) return range;
  const double room = std::max(range.width(), 1e-10 * magnitude);
  return {range.low - room, range.high + room};
}

Ticks nice_ticks(Range range, int at_most) {
  range = usable(range);
  const Step step = step_for(range, at_most);
  Ticks ticks{step.value(), {}};
  const double last = last_multiple(range, step);
  for (double k = first_multiple(range, step); k <= last; ++k)
    ticks.values.push_back(step.multiple(k) + 0.0);  // + 0 turns -0 into 0
  return ticks;
}

double Axis::label_width() const {
  double width = 0;
  for (const std::string& label : labels)
    width = std::max(width, text_width(label, style::small_size));
  return width;
}

Axis make_axis(const Quantity& quantity, Range domain, Range page, int at_most_ticks) {
  domain = usable(domain);
  const Ticks ticks = nice_ticks(domain, at_most_ticks);
  Axis axis{{domain, page}, ticks.values, {}, {}};

  // More than five digits before a label changes are an offset.
  const double magnitude = largest_magnitude(domain);
  const bool far_away = !ticks.values.empty() && magnitude > 2e4 * ticks.step;
  const double offset = far_away ? ticks.values.front() : 0;
  const int exponent = common_exponent(far_away ? domain.width() : magnitude);
  const double step = decimal(ticks.step, -exponent);
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-6)));
  for (const double tick : ticks.values)
    axis.labels.push_back(
        with_minus_sign(fmt::format("{:.{}f}", decimal(tick - offset, -exponent) + 0.0, decimals)));
  axis.title = axis_title(quantity, offset, exponent);
  return axis;
}

Axis make_log_axis(const Quantity& quantity, Range domain, Range page) {
  const Range exponents{std::log10(domain.low), std::log10(domain.high)};
  Axis axis{{exponents, page}, {}, {}, axis_title(quantity, 0, 0)};
  const double decade = std::abs(page.width()) / exponents.width();
  const bool plain = domain.low >= 1e-3 && domain.high < 1e5;
  // Upright, labels stand one over the other and need their height only.
  const bool upright = page.low > page.high;
  const double room = upright ? 32 : plain ? 70 : 120;
  for (int power = static_cast<int>(std::floor(exponents.low)); power <= exponents.high; ++power)
    for (const int mantissa : {1, 2, 5}) {
      const double tick = power + std::log10(mantissa);
      if (tick < exponents.low - slack || tick > exponents.high + slack) continue;
      if (mantissa > 1 && decade < room) continue;
      const std::string factor = mantissa > 1 ? fmt::format("{}·", mantissa) : "";
      axis.ticks.push_back(tick);
      axis.labels.push_back(plain ? number_text(decimal(mantissa, power))
                                  : factor + "10" + superscript(power));
    }
  return axis;
}

void draw_bottom_axis(Svg& svg, const Axis& axis, double y) {
  const auto scope = svg.group("axis");
  const Range page = axis.scale.page;
  hairline(svg, {page.low, y}, {page.high, y});
  for (std::size_t k = 0; k < axis.ticks.size(); ++k) {
    const double x = axis.scale(axis.ticks[k]);
    hairline(svg, {x, y}, {x, y + tick_length});
    svg.text({x, y + tick_length + style::small_size}, axis.labels[k],
             {.size = style::small_size, .anchor = "middle"});
  }
}

void draw_left_axis(Svg& svg, const Axis& axis, double x) {
  const auto scope = svg.group("axis");
  const Range page = axis.scale.page;
  hairline(svg, {x, page.low}, {x, page.high});
  for (std::size_t k = 0; k < axis.ticks.size(); ++k) {
    const double y = axis.scale(axis.ticks[k]);
    hairline(svg, {x - tick_length, y}, {x, y});
    svg.text({x - tick_length - 1.5, y + 0.36 * style::small_size}, axis.labels[k],
             {.size = style::small_size, .anchor = "end"});
  }
}

void draw_bottom_title(Svg& svg, const Axis& axis, double y) {
  svg.text({(axis.scale.page.low + axis.scale.page.high) / 2, y + bottom_axis_height - 5},
           axis.title, {.size = style::label_size, .anchor = "middle"});
}

void draw_left_title(Svg& svg, const Axis& axis, double x) {
  svg.text({x - axis.label_width() - tick_length - 5.5,
            (axis.scale.page.low + axis.scale.page.high) / 2},
           axis.title, {.size = style::label_size, .anchor = "middle", .rotation = -90});
}

}  // namespace wander::figure
