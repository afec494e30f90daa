#include "tools/figure/film_panel.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/figure/legend.h"

namespace wander::figure {
namespace {

constexpr double line_width = 0.9, reference_width = 0.6, band_opacity = 0.25;
constexpr double dot_radius = 1.3, dot_spacing = 4, arrow_size = 2.7;

std::string hatch_id(const style::Stroke& stroke) {
  return fmt::format("hatch-{}", stroke.colour.substr(1));
}

// Heights on the page, kept near it however large the value: the clip path cuts the rest.
double height(const Panel& panel, double value) {
  constexpr double beyond = 20;
  return std::clamp(panel.y(value), panel.y.page.high - beyond, panel.y.page.low + beyond);
}

// Whether the line and the band go on from one bar to the next.
bool adjoin(const Bar& left, const Bar& right) { return left.position.high == right.position.low; }

std::string steps(const Panel& panel, std::span<const Bar> bars) {
  std::string data;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double y = height(panel, bars[k].value);
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
    const double top = height(panel, bar.value + *bar.half_width);
    const double bottom = height(panel, bar.value - *bar.half_width);
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
                      {"fill", fmt::format("url(#{})", hatch_id(trace.stroke))}});
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

Vector middle(const Panel& panel, const Bar& bar) {
  return {panel.x((bar.position.low + bar.position.high) / 2), panel.y(bar.value)};
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
    const bool above = bar.value > panel.y.domain.high;
    draw_arrow_head(svg, {at.x, above ? panel.y.page.high : panel.y.page.low}, above ? 1 : -1,
                    trace.stroke);
    free_from = at.x + 2 * arrow_size;
  }
}

// Named after what it holds, so that equal names in one page are equal paths.
std::string define_clip(Svg& svg, const Panel& panel) {
  const Range x = panel.x.page, y = panel.y.page;
  const std::string id = fmt::format("clip-{}-{}-{}-{}", number(x.low), number(y.high),
                                     number(x.width()), number(-y.width()));
  if (!svg.is_new(id)) return id;
  const auto scope = svg.open("clipPath", {{"id", id}});
  svg.element("rect", {{"x", x.low}, {"y", y.high}, {"width", x.width()}, {"height", -y.width()}});
  return id;
}

}  // namespace

void define_hatching(Svg& svg, std::span<const style::Stroke> strokes) {
  const auto definitions = svg.open("defs", {});
  for (const style::Stroke& stroke : strokes) {
    if (!svg.is_new(hatch_id(stroke))) continue;
    const auto pattern = svg.open("pattern", {{"id", hatch_id(stroke)},
                                              {"patternUnits", "userSpaceOnUse"},
                                              {"width", 2.2},
                                              {"height", 2.2},
                                              {"patternTransform", "rotate(45)"}});
    svg.line({1.1, 0}, {1.1, 2.2}, {{"stroke", stroke.colour}, {"stroke-width", 0.45}});
  }
}

void draw_traces(Svg& svg, const Panel& panel, std::span<const Trace> traces,
                 std::span<const Bar> reference) {
  const std::string clip = define_clip(svg, panel);
  {
    const auto scope = svg.open("g", {{"clip-path", fmt::format("url(#{})", clip)}});
    for (const Trace& trace : traces) draw_bands(svg, panel, trace);
    for (const Trace& trace : traces)
      draw_line(svg, steps(panel, trace.bars), trace.stroke, line_width);
    if (!reference.empty())
      draw_line(svg, steps(panel, reference), {style::ink, "none"}, reference_width);
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
  draw_line(svg, "M" + coordinates(left) + "h" + number(swatch_width), {style::ink, "none"},
            reference_width);
}

void draw_unreliable_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  svg.element("rect", {{"x", left.x},
                       {"y", left.y - 3},
                       {"width", swatch_width},
                       {"height", 6},
                       {"fill", fmt::format("url(#{})", hatch_id(stroke))}});
  draw_line(svg, "M" + coordinates(left) + "h" + number(swatch_width), stroke, line_width);
  draw_hollow_dot(svg, left + Vector{swatch_width / 2, 0}, stroke);
}

void draw_beyond_swatch(Svg& svg, Vector left, const style::Stroke& stroke) {
  draw_arrow_head(svg, left + Vector{swatch_width / 2, -2}, 1, stroke);
}

}  // namespace wander::figure
