#include "draw/figure/film_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/figure/legend.h"
#include "draw/figure/meanings.h"

namespace wander::figure {
namespace {

constexpr double line_width = 0.9, reference_width = 0.6, band_opacity = 0.25;
constexpr double dot_radius = 1.3, dot_spacing = 7, arrow_size = 2.7;
// A line that goes up and down for more than this many widths of the panel is drawn thinner.
constexpr double calm_travel = 2.5, least_line_width = 0.45;

// Whether the line and the band go on from one bar to the next.
bool adjoin(const Bar& left, const Bar& right) { return left.position.high == right.position.low; }

std::string steps(const Panel& panel, std::span<const Bar> bars) {
  std::string data;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double y = panel.height(bars[k].value);
    if (k > 0 && adjoin(bars[k - 1], bars[k]))
      data += "V" + number(y);
    else
      data += "M" + coordinates({panel.x(bars[k].position.low), y});
    data += "H" + number(panel.x(bars[k].position.high));
  }
  return data;
}

// The region between the ends of the intervals, as one polygon.
std::string band(const Panel& panel, std::span<const Bar> bars) {
  std::string there, back;
  for (const Bar& bar : bars) {
    const double left = panel.x(bar.position.low), right = panel.x(bar.position.high);
    const double top = panel.height(bar.value + *bar.half_width);
    const double bottom = panel.height(bar.value - *bar.half_width);
    there += (there.empty() ? "M" : "L") + coordinates({left, top}) + "H" + number(right);
    back = "L" + coordinates({right, bottom}) + "H" + number(left) + back;
  }
  return there + back + "Z";
}

void draw_bands(Svg& svg, const Panel& panel, const Trace& trace) {
  const std::span<const Bar> bars = trace.bars;
  for (std::size_t first = 0, end = 0; first < bars.size(); first = end) {
    end = first + 1;
    if (!bars[first].half_width) continue;
    while (end < bars.size() && bars[end].half_width && bars[end].trust == bars[first].trust &&
           adjoin(bars[end - 1], bars[end]))
      ++end;
    const std::string data = band(panel, bars.subspan(first, end - first));
    if (bars[first].trust == Trust::reliable)
      svg.path(data,
               {{"class", "band"}, {"fill", trace.stroke.colour}, {"fill-opacity", band_opacity}});
    else
      svg.path(data, {{"class", "band unreliable"},
                      {"fill", define_fill(svg, unreliable_fill(trace.stroke.colour))}});
  }
}

void draw_line(Svg& svg, const std::string& data, const style::Stroke& stroke, double width) {
  svg.path(data, {{"stroke", stroke.colour},
                  {"stroke-width", width},
                  {"stroke-dasharray", stroke.dashes},
                  {"stroke-linejoin", "round"},
                  {"fill", "none"}});
}

void draw_hollow_dot(Svg& svg, Vector at, const style::Stroke& stroke) {
  svg.element("circle", {{"class", "unreliable"},
                         {"cx", at.x},
                         {"cy", at.y},
                         {"r", dot_radius},
                         {"fill", style::paper},
                         {"stroke", stroke.colour},
                         {"stroke-width", 0.6}});
}

void draw_arrow_head(Svg& svg, Vector tip, double along, const style::Stroke& stroke) {
  svg.path("M" + coordinates(tip) + "l" + coordinates({-arrow_size, along * 1.6 * arrow_size}) +
               "h" + number(2 * arrow_size) + "Z",
           {{"class", "beyond"},
            {"fill", stroke.colour},
            {"stroke", style::paper},
            {"stroke-width", 0.7},
            {"paint-order", "stroke"}});
}

// The ink of a line stays about the same however noisy it is.
double line_width_of(const Panel& panel, std::span<const Bar> bars) {
  double travel = 0;
  for (std::size_t k = 1; k < bars.size(); ++k)
    travel += std::abs(panel.height(bars[k].value) - panel.height(bars[k - 1].value));
  const double widths = travel / panel.x.page.width();
  return std::max(least_line_width, line_width * std::min(1., calm_travel / widths));
}

Vector middle(const Panel& panel, const Bar& bar) {
  return {panel.x((bar.position.low + bar.position.high) / 2), panel.height(bar.value)};
}

// Dots keep a distance, so that thin bins do not make a chain of them.
void draw_hollow_dots(Svg& svg, const Panel& panel, const Trace& trace) {
  double free_from = panel.x.page.low - dot_spacing;
  for (const Bar& bar : trace.bars) {
    if (bar.trust == Trust::reliable || panel.is_beyond(bar.value)) continue;
    const Vector at = middle(panel, bar);
    if (at.x < free_from) continue;
    draw_hollow_dot(svg, at, trace.stroke);
    free_from = at.x + dot_spacing;
  }
}

void draw_arrow_heads(Svg& svg, const Panel& panel, const Trace& trace) {
  double free_from = panel.x.page.low - 2 * arrow_size;
  for (const Bar& bar : trace.bars) {
    const Vector at = middle(panel, bar);
    if (!panel.is_beyond(bar.value) || at.x < free_from) continue;
    const bool above = panel.is_above(bar.value);
    const Range page = panel.y.axis.scale.page;
    draw_arrow_head(svg, {at.x, above ? page.high : page.low}, above ? 1 : -1, trace.stroke);
    free_from = at.x + 2 * arrow_size;
  }
}

// Named after what it holds, so that equal names in one page are equal paths.
std::string define_clip(Svg& svg, const Panel& panel) {
  const Range x = panel.x.page, y = panel.y.axis.scale.page;
  const std::string id = fmt::format("clip-{}-{}-{}-{}", number(x.low), number(y.high),
                                     number(x.width()), number(-y.width()));
  if (!svg.is_new(id)) return id;
  const auto scope = svg.open("clipPath", {{"id", id}});
  svg.element("rect", {{"x", x.low}, {"y", y.high}, {"width", x.width()}, {"height", -y.width()}});
  return id;
}

}  // namespace

double Panel::height(double value) const {
  constexpr double beyond = 20;
  return y.shows(value) ? y(value) : y.axis.scale.page.low + beyond;
}

void define_hatching(Svg& svg, std::span<const style::Stroke> strokes) {
  for (const style::Stroke& stroke : strokes) define_fill(svg, unreliable_fill(stroke.colour));
}

void draw_traces(Svg& svg, const Panel& panel, std::span<const Trace> traces,
                 std::span<const Bar> reference) {
  const std::string clip = define_clip(svg, panel);
  {
    const auto scope = svg.open("g", {{"clip-path", fmt::format("url(#{})", clip)}});
    for (const Trace& trace : traces) draw_bands(svg, panel, trace);
    for (const Trace& trace : traces)
      draw_line(svg, steps(panel, trace.bars), trace.stroke, line_width_of(panel, trace.bars));
    if (!reference.empty()) draw_line(svg, steps(panel, reference), style::known, reference_width);
  }
  for (const Trace& trace : traces) {
    draw_hollow_dots(svg, panel, trace);
    draw_arrow_heads(svg, panel, trace);
  }
}

void draw_trace_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  draw_line(svg, "M" + coordinates(left) + "h" + number(swatch_width), stroke, line_width + 0.2);
}

void draw_band_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  svg.element("rect", {{"x", left.x},
                       {"y", left.y - 3},
                       {"width", swatch_width},
                       {"height", 6},
                       {"fill", stroke.colour},
                       {"fill-opacity", band_opacity}});
}

void draw_reference_swatch(Svg& svg, Vector left) {
  draw_line(svg, "M" + coordinates(left) + "h" + number(swatch_width), style::known,
            reference_width);
}

void draw_unreliable_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  svg.element("rect", {{"x", left.x},
                       {"y", left.y - 3},
                       {"width", swatch_width},
                       {"height", 6},
                       {"fill", define_fill(svg, unreliable_fill(stroke.colour))}});
  draw_line(svg, "M" + coordinates(left) + "h" + number(swatch_width), stroke, line_width);
  draw_hollow_dot(svg, left + Vector{swatch_width / 2, 0}, stroke);
}

void draw_above_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  draw_arrow_head(svg, left + Vector{swatch_width / 2, -2}, 1, stroke);
}

void draw_below_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  draw_arrow_head(svg, left + Vector{swatch_width / 2, 2}, -1, stroke);
}

}  // namespace wander::figure
