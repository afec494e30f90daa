#include "draw/figure/film_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/film_statistics.h"
#include "draw/figure/block.h"
#include "draw/figure/film_layout.h"
#include "draw/figure/legend.h"
#include "draw/figure/scale_of_ten.h"
#include "draw/figure/scene_inset.h"
#include "draw/figure/style.h"
#include "lab/wording.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

// What is drawn, before it has a place.
struct Content {
  std::vector<Trace> traces;
  std::vector<Bar> reference;
  Layout layout;
  Range values;
};

ChartAxis value_axis(const Content& content, const FilmFigureOptions& options, Range row) {
  const int ticks = content.layout == Layout::overlay ? 7 : 5;
  return chart_axis({options.axes.value, options.values, {}}, content.values, row, ticks);
}

// As good as the one that is drawn, for deciding on the layout.
Panel draft_panel(const Content& content, const FilmFigureOptions& options) {
  return {{options.axes.extent, {0, panel_room(options)}},
          value_axis(content, options, {overlay_height, 0}),
          content.values};
}

Content prepare(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options) {
  Content content{{}, {}, options.layout, {}};
  const std::size_t most = bars_in(options);
  std::vector<std::vector<Bar>> bars;
  for (const LabelledFilm& film : films)
    bars.push_back(bars_of(film.rendering.film, options.axes.extent, most));
  if (options.reference)
    content.reference = bars_of(options.reference->rendering.film, options.axes.extent, most);
  const auto range = options.values == Spacing::logarithmic ? log_value_range : value_range;
  content.values = range(bars, content.reference);
  for (std::size_t k = 0; k < films.size(); ++k)
    content.traces.push_back({std::move(bars[k]), style::films[k % style::films.size()]});
  if (content.layout == Layout::automatic)
    content.layout = best_layout(content.traces, draft_panel(content, options));
  // In panels the place tells the films apart: one style for all.
  if (content.layout == Layout::panels)
    for (Trace& trace : content.traces) trace.stroke = style::films[0];
  return content;
}

// The error is that of the whole film, relative to the film.
std::string summary(const LabelledFilm& film) {
  const Rendering& run = film.rendering;
  std::string work;
  if (run.samples > 0) work = work_in_words(run) + ", ";  // an exact film has none
  if (std::isfinite(run.seconds) && run.seconds > 0) work += duration_in_words(run.seconds) + ", ";
  std::string text =
      fmt::format("{}: {}error {}", film.label, work, percent(relative_error(run.film)));
  return run.complete ? text : text + ", interrupted";
}

bool has_unreliable(const Trace& trace) {
  return std::any_of(trace.bars.begin(), trace.bars.end(),
                     [](const Bar& bar) { return bar.trust == Trust::unreliable; });
}

// In the power of ten that the axis takes out of its own labels.
std::string on_scale_of(Range values, double value, const std::string& unit) {
  constexpr double many_digits = 1e6;
  const int exponent = common_exponent(std::max(std::abs(values.low), std::abs(values.high)));
  const double scaled = decimal(value, -exponent);
  if (exponent == 0 || scaled >= many_digits) return fmt::format("{} {}", number_text(value), unit);
  const double digit = scaled < 1000 ? 1 : std::pow(10, std::floor(std::log10(scaled)) - 2);
  const std::string digits = scaled < 1000
                                 ? number_text(scaled)
                                 : fmt::format("{:.0f}", std::round(scaled / digit) * digit);
  return fmt::format("{}·10{} {}", digits, superscript(exponent), unit);
}

// Of all values that are drawn; without any, nothing is beyond an axis.
Range values_of(const std::vector<Trace>& traces) {
  Range values{INFINITY, -INFINITY};
  for (const Trace& trace : traces)
    for (const Bar& bar : trace.bars)
      values = {std::min(values.low, bar.value), std::max(values.high, bar.value)};
  return values;
}

std::string band_text(const std::vector<LabelledFilm>& films, std::size_t most_shown) {
  std::size_t most = 1;
  for (const LabelledFilm& film : films)
    most = std::max(most, bins_per_bar(film.rendering.film.value.size(), most_shown));
  if (most == 1) return "95 % interval of each bin";
  return fmt::format("95 % interval; each step averages {} bins", most);
}

std::vector<LegendEntry> legend_of(const std::vector<LabelledFilm>& films, const Content& content,
                                   const FilmFigureOptions& options) {
  std::vector<LegendEntry> entries;
  // What all films share is explained in grey, unless there is one colour only.
  const bool several_colours = content.layout == Layout::overlay && films.size() > 1;
  const style::Stroke common = several_colours ? style::neutral : content.traces.front().stroke;
  const auto add = [&](const auto& draw, const style::Stroke& stroke, std::string text) {
    entries.push_back({[=](Svg& svg, Vector left) { draw(svg, left, stroke); }, std::move(text)});
  };
  if (content.layout == Layout::overlay)
    for (std::size_t k = 0; k < films.size(); ++k)
      add(draw_trace_swatch, content.traces[k].stroke, summary(films[k]));
  if (options.reference)
    entries.push_back({draw_reference_swatch, "reference: " + options.reference->label});
  add(draw_band_swatch, common, band_text(films, bars_in(options)));
  if (std::any_of(content.traces.begin(), content.traces.end(), has_unreliable))
    add(draw_unreliable_swatch, common, "unreliable bin");
  const Range drawn = values_of(content.traces);
  const auto on_scale = [&](double value) {
    return on_scale_of(content.values, value, options.axes.value.unit);
  };
  if (drawn.high > content.values.high)
    add(draw_above_swatch, common, "beyond the axis, up to " + on_scale(drawn.high));
  if (drawn.low < content.values.low)
    add(draw_below_swatch, common, "beyond the axis, down to " + on_scale(drawn.low));
  return entries;
}

// Faint lines at the ticks, for reading values across a wide panel.
void draw_grid(Svg& svg, const Axis& values, Range x) {
  const auto scope = svg.group("grid");
  for (const double tick : values.ticks)
    svg.line({x.low, values.scale(tick)}, {x.high, values.scale(tick)},
             {{"stroke", style::faint}, {"stroke-width", 0.4}});
}

// Wide bands first, so that the films that are known best end on top.
std::vector<Trace> by_error(std::span<const Trace> traces) {
  std::vector<Trace> sorted(traces.begin(), traces.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const Trace& a, const Trace& b) {
    return mean_half_width(a.bars) > mean_half_width(b.bars);
  });
  return sorted;
}

void draw_row(Svg& svg, const Content& content, std::span<const Trace> traces,
              const Axis& positions, const ChartAxis& values) {
  draw_grid(svg, values.axis, positions.scale.page);
  draw_traces(svg, {positions.scale, values, content.values}, traces, content.reference);
  draw_left_axis(svg, values.axis, positions.scale.page.low - 3);
}

std::vector<std::string> header_lines(const LabelledFilm& film, double room) {
  return wrapped(summary(film), style::small_size, room);
}

void draw_header(Svg& svg, const LabelledFilm& film, const FilmPage& page, Range row) {
  const std::vector<std::string> lines = header_lines(film, page.x.width());
  double y = row.high - 4.5 - page.header_line * static_cast<double>(lines.size() - 1);
  for (const std::string& line : lines) {
    svg.text({page.x.low, y}, line, {.size = style::small_size});
    y += page.header_line;
  }
}

void draw_rows(Svg& svg, const std::vector<LabelledFilm>& films, const Content& content,
               const FilmFigureOptions& options, const FilmPage& page) {
  const int ticks = static_cast<int>(page.x.width() / 28);
  const Axis positions = make_axis(options.axes.position, options.axes.extent, page.x, ticks);
  const std::span<const Trace> traces = content.traces;
  for (std::size_t k = 0; k < page.rows.size(); ++k) {
    const ChartAxis values = value_axis(content, options, page.rows[k]);
    if (content.layout == Layout::overlay) {
      draw_row(svg, content, by_error(traces), positions, values);
      continue;
    }
    draw_header(svg, films[k], page, page.rows[k]);
    draw_row(svg, content, traces.subspan(k, 1), positions, values);
  }
  const double bottom = page.rows.back().low + 3;
  draw_bottom_axis(svg, positions, bottom);
  draw_bottom_title(svg, positions, bottom);
  const Range all{page.rows.back().low, page.rows.front().high};
  Axis title = value_axis(content, options, all).axis;
  title.labels = value_axis(content, options, page.rows.front()).axis.labels;
  draw_left_title(svg, title, page.x.low - 3);
}

std::string spoken(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options) {
  std::string text = fmt::format("{} over {}, with 95 % confidence intervals.",
                                 options.axes.value.name, options.axes.position.name);
  for (const LabelledFilm& film : films) text += " " + summary(film) + ".";
  return text;
}

// What the page has to hold.
FilmContent measured(const std::vector<LabelledFilm>& films, const Content& content,
                     const FilmFigureOptions& options, const std::vector<LegendEntry>& entries) {
  const bool overlay = content.layout == Layout::overlay;
  const double row = overlay ? overlay_height : panel_height;
  FilmContent measures{
      .rows = films.size(),
      .header_lines = 0,
      .value_labels = value_axis(content, options, {row, 0}).axis.label_width(),
      .legend_height = [&entries](double width) { return legend_height(entries, width); }};
  const double room = panel_room(options) - measures.value_labels;
  if (!overlay)
    for (const LabelledFilm& film : films)
      measures.header_lines = std::max(measures.header_lines, header_lines(film, room).size());
  return measures;
}

}  // namespace

std::string film_figure(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options) {
  const Content content = prepare(films, options);
  const std::vector<LegendEntry> entries = legend_of(films, content, options);
  const FilmPage page = lay_out(measured(films, content, options, entries), options);

  Svg svg(page.size, options.title.empty() ? "Film" : options.title, spoken(films, options));
  std::vector<style::Stroke> strokes;
  for (const Trace& trace : content.traces) strokes.push_back(trace.stroke);
  strokes.push_back(style::neutral);
  define_hatching(svg, strokes);
  draw_title(svg, options.title, {page.size.x / 2, style::margin}, block_width(page.size.x));
  if (options.inset) draw_inset(svg, *options.inset, page.inset, page.inset_size);
  draw_rows(svg, films, content, options, page);
  draw_legend(svg, entries, {page.legend.low, page.legend_top}, page.legend.width());
  return std::move(svg).finish();
}

}  // namespace wander::figure
