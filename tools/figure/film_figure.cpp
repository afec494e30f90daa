#include "tools/figure/film_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/number_text.h"
#include "core/output/film_statistics.h"
#include "tools/figure/film_panel.h"
#include "tools/figure/legend.h"
#include "tools/figure/scene_inset.h"
#include "tools/figure/style.h"
#include "tools/wording.h"

namespace wander::figure {
namespace {

constexpr double inset_width = 158, inset_gap = 10;
constexpr double overlay_height = 122, panel_height = 62, panel_header = 12, panel_gap = 5;

// What is drawn, before it has a place.
struct Content {
  std::vector<Trace> traces;
  std::vector<Bar> reference;
  Layout layout;
  Range values;
  int value_ticks;
};

// Where it is drawn.
struct Page {
  Vector size;
  double top;               // of the first panel, its header included
  Range x;                  // of the panels
  std::vector<Range> rows;  // of the panels, bottom (the greater y) first
  Range legend;             // across
  double legend_top;
};

Layout resolved(Layout layout, std::size_t films) {
  if (layout != Layout::automatic) return layout;
  return films <= 2 ? Layout::overlay : Layout::panels;
}

Content prepare(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options) {
  Content content{{}, {}, resolved(options.layout, films.size()), {}, 0};
  std::vector<std::vector<Bar>> bars;
  for (const LabelledFilm& film : films)
    bars.push_back(bars_of(film.rendering.film, options.axes.extent));
  if (options.reference)
    content.reference = bars_of(options.reference->rendering.film, options.axes.extent);
  content.value_ticks = content.layout == Layout::overlay ? 7 : 5;
  content.values = value_range(bars, content.reference);
  for (std::size_t k = 0; k < films.size(); ++k) {
    // In panels the place tells the films apart: one style for all.
    const std::size_t index = content.layout == Layout::overlay ? k % style::films.size() : 0;
    content.traces.push_back({std::move(bars[k]), style::films[index]});
  }
  return content;
}

// The error is that of the whole film, relative to the film.
std::string summary(const LabelledFilm& film) {
  const Rendering& run = film.rendering;
  std::string text = fmt::format("{}: {} samples, {}, error {}", film.label,
                                 count_in_words(static_cast<double>(run.samples)),
                                 duration_in_words(run.seconds), percent(relative_error(run.film)));
  return run.complete ? text : text + ", interrupted";
}

bool has_unreliable(const Trace& trace) {
  return std::any_of(trace.bars.begin(), trace.bars.end(),
                     [](const Bar& bar) { return bar.trust == Trust::unreliable; });
}

bool has_beyond(const Trace& trace, Range values) {
  return std::any_of(trace.bars.begin(), trace.bars.end(), [&](const Bar& bar) {
    return bar.value > values.high || bar.value < values.low;
  });
}

double largest_value(const std::vector<Trace>& traces) {
  double largest = 0;
  for (const Trace& trace : traces)
    for (const Bar& bar : trace.bars) largest = std::max(largest, bar.value);
  return largest;
}

std::string band_text(const std::vector<LabelledFilm>& films) {
  std::size_t most = 1;
  for (const LabelledFilm& film : films)
    most = std::max(most, bins_per_bar(film.rendering.film.value.size()));
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
  add(draw_band_swatch, common, band_text(films));
  if (std::any_of(content.traces.begin(), content.traces.end(), has_unreliable))
    add(draw_unreliable_swatch, common, "unreliable bin");
  const auto beyond = [&](const Trace& trace) { return has_beyond(trace, content.values); };
  if (std::any_of(content.traces.begin(), content.traces.end(), beyond))
    add(draw_beyond_swatch, common,
        fmt::format("beyond the axis, up to {} {}", number_text(largest_value(content.traces)),
                    options.axes.value.unit));
  return entries;
}

Page lay_out(const Content& content, const FilmFigureOptions& options, double value_labels,
             const std::vector<LegendEntry>& entries) {
  const double width = options.inset ? style::page_width : style::column_width;
  const double indent = options.inset ? inset_width + inset_gap : 0;
  Page page{};
  page.top = style::margin + (options.title.empty() ? 4 : 2.1 * style::title_size);
  page.x = {style::margin + indent + left_axis_gap + value_labels, width - style::margin - 8};
  double y = page.top;
  if (content.layout == Layout::overlay) {
    page.rows = {{y + overlay_height, y}};
  } else {
    for (std::size_t k = 0; k < content.traces.size(); ++k) {
      y = page.top + static_cast<double>(k) * (panel_height + panel_header + panel_gap) +
          panel_header;
      page.rows.push_back({y + panel_height, y});
    }
  }
  // A single column is narrow: there the legend begins left of the axis.
  page.legend = {options.inset ? page.x.low : style::margin + 6, width - style::margin};
  page.legend_top = page.rows.back().low + bottom_axis_height + 3;
  page.size = {width,
               page.legend_top + legend_height(entries, page.legend.width()) + style::margin};
  return page;
}

// Faint lines at the ticks, for reading values across a wide panel.
void draw_grid(Svg& svg, const Axis& values, Range x) {
  const auto scope = svg.group("grid");
  for (const double tick : values.ticks)
    svg.line({x.low, values.scale(tick)}, {x.high, values.scale(tick)},
             {{"stroke", style::faint}, {"stroke-width", 0.4}});
}

Axis value_axis(const Content& content, const FilmFigureOptions& options, Range row) {
  return make_axis(options.axes.value, content.values, row, content.value_ticks);
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
              const Axis& positions, const Axis& values) {
  draw_grid(svg, values, positions.scale.page);
  draw_traces(svg, {positions.scale, values.scale}, traces, content.reference);
  draw_left_axis(svg, values, positions.scale.page.low - 3);
}

void draw_rows(Svg& svg, const std::vector<LabelledFilm>& films, const Content& content,
               const FilmFigureOptions& options, const Page& page) {
  const int ticks = static_cast<int>(page.x.width() / 28);
  const Axis positions = make_axis(options.axes.position, options.axes.extent, page.x, ticks);
  const std::span<const Trace> traces = content.traces;
  for (std::size_t k = 0; k < page.rows.size(); ++k) {
    const Axis values = value_axis(content, options, page.rows[k]);
    if (content.layout == Layout::overlay) {
      draw_row(svg, content, by_error(traces), positions, values);
      continue;
    }
    svg.text({page.x.low, page.rows[k].high - 4.5},
             shortened(summary(films[k]), style::small_size, page.x.width()),
             {.size = style::small_size});
    draw_row(svg, content, traces.subspan(k, 1), positions, values);
  }
  const double bottom = page.rows.back().low + 3;
  draw_bottom_axis(svg, positions, bottom);
  draw_bottom_title(svg, positions, bottom);
  const Range all{page.rows.back().low, page.rows.front().high};
  draw_left_title(svg, value_axis(content, options, all), page.x.low - 3);
}

std::string spoken(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options) {
  std::string text = fmt::format("{} over {}, with 95 % confidence intervals.",
                                 options.axes.value.name, options.axes.position.name);
  for (const LabelledFilm& film : films) text += " " + summary(film) + ".";
  return text;
}

void draw_title(Svg& svg, const std::string& title, const Page& page) {
  if (title.empty()) return;
  svg.text({page.size.x / 2, style::margin + style::title_size},
           shortened(title, style::bold_width * style::title_size, page.size.x - 2 * style::margin),
           {.size = style::title_size, .anchor = "middle", .weight = "bold"});
}

}  // namespace

std::string film_figure(const std::vector<LabelledFilm>& films, const FilmFigureOptions& options) {
  const Content content = prepare(films, options);
  const std::vector<LegendEntry> entries = legend_of(films, content, options);
  const double value_labels = value_axis(content, options, {1, 0}).label_width();
  const Page page = lay_out(content, options, value_labels, entries);

  Svg svg(page.size, options.title.empty() ? "Film" : options.title, spoken(films, options));
  std::vector<style::Stroke> strokes;
  for (const Trace& trace : content.traces) strokes.push_back(trace.stroke);
  strokes.push_back(style::neutral);
  define_hatching(svg, strokes);
  draw_title(svg, options.title, page);
  if (options.inset) {
    const double room = page.rows.back().low - page.top + bottom_axis_height;
    const double height = inset_height(*options.inset, inset_width, room);
    draw_inset(svg, *options.inset, {style::margin, page.top + (room - height) / 2},
               {inset_width, height});
  }
  draw_rows(svg, films, content, options, page);
  draw_legend(svg, entries, {page.legend.low, page.legend_top}, page.legend.width());
  return std::move(svg).finish();
}

}  // namespace wander::figure
