#include "draw/figure/parts_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/film_statistics.h"
#include "core/image_shape.h"
#include "core/tint.h"
#include "draw/figure/chart.h"
#include "draw/figure/map_panel.h"
#include "draw/figure/meanings.h"
#include "draw/figure/picture_panel.h"
#include "draw/figure/share_bars.h"
#include "draw/figure/style.h"
#include "lab/wording.h"
#include "records/tone.h"

namespace wander::figure {
namespace {

constexpr double bins_height = 150, shares_height = 80;
constexpr double label_room = 26;
constexpr const char *samples = "samples", *chains = "chains";

const PoolingRecord& pooling_of(const Rendering& run) { return run.pooling.value(); }

// The same film with what one side carries of it, known where the film is; what noise makes of none is
// none.
FilmEstimate part_of_samples(const Rendering& run) {
  FilmEstimate part{.shape = run.film.shape, .value = pooling_of(run).film_of_samples};
  for (std::size_t i = 0; i < part.value.size(); ++i)
    part.value[i] = !std::isfinite(run.film.value[i]) ? not_known
                    : part.value[i] > 0               ? part.value[i]
                                                      : 0;
  part.standard_error.assign(part.value.size(), 0);
  part.reliable.assign(part.value.size(), true);
  return part;
}
FilmEstimate part_of_chains(const Rendering& run) {
  FilmEstimate part{.shape = run.film.shape, .value = run.film.value};
  for (std::size_t i = 0; i < part.value.size(); ++i)
    part.value[i] = std::max(part.value[i] - pooling_of(run).film_of_samples[i], 0.0);
  return part;
}

std::string summary(const Rendering& run) {
  return fmt::format("{}: independent samples carry {} of the light, chains {}.", run.method,
                     percent(pooling_of(run).light_of_samples),
                     percent(1 - pooling_of(run).light_of_samples));
}

// ---- by class of path

std::vector<Part> sides() {
  const auto& fills = class_fills();
  return {{samples, fills[0], "independent samples"}, {chains, fills[1], "chains"}};
}

std::vector<Block> class_bars(const Rendering& run, double width) {
  std::vector<ShareBar> bars;
  for (const ClassRecord& each : pooling_of(run).classes) {
    if (bars.size() == most_classes) break;
    const double of_samples = std::clamp(each.of_samples, 0.0, 1.0);
    bars.push_back({each.path_class,
                    fmt::format("{} of the light", percent(each.light)),
                    {{samples, of_samples}, {chains, 1 - of_samples}}});
  }
  if (bars.empty()) return {};
  const std::size_t left_out = pooling_of(run).classes.size() - bars.size();
  return {share_bars(
      left_out == 0 ? "Who carries the light of each class of path, by the states of the chains"
                    : fmt::format("Who carries the light of the brightest classes of path, by the "
                                  "states of the chains ({} more are not shown)",
                                  left_out),
      std::move(bars), sides(), width)};
}

// ---- of bins

Series line(std::string label, std::size_t look, std::span<const Bar> bars, auto value) {
  Series series{.label = std::move(label),
                .look = look_of(look),
                .connection = Connection::staircase,
                .marks = Marks::none};
  for (std::size_t i = 0; i < bars.size(); ++i)
    series.points.push_back({bars[i].position.low, value(i)});
  if (bars.empty()) return series;
  series.points.push_back({bars.back().position.high, series.points.back().y});
  return series;
}

Block film_chart(std::span<const Bar> all, std::span<const Bar> of_samples, const FilmAxes& axes,
                 double width) {
  ChartPanel panel;
  panel.series = {line("all", 0, all, [&](std::size_t i) { return all[i].value; }),
                  line("carried by samples", 1, of_samples,
                       [&](std::size_t i) { return of_samples[i].value; })};
  double most = 0;
  for (const Bar& bar : all) most = std::max(most, bar.value);
  return chart_block({.x = {axes.position, Spacing::linear, axes.extent},
                      .y = {axes.value, Spacing::linear, Range{0, most > 0 ? 1.05 * most : 1}},
                      .panels = {panel},
                      .guides = {},
                      .panel_height = bins_height,
                      .label_room = label_room},
                     width);
}

Block share_chart(std::span<const Bar> all, std::span<const Bar> of_samples, const FilmAxes& axes,
                  double width) {
  ChartPanel panel;
  panel.series = {line("", 0, all, [&](std::size_t i) {
    return all[i].value > 0 ? std::clamp(1 - of_samples[i].value / all[i].value, 0.0, 1.0)
                            : not_known;
  })};
  return chart_block({.x = {axes.position, Spacing::linear, axes.extent},
                      .y = {{"share of chains", ""}, Spacing::linear, Range{0, 1}},
                      .panels = {panel},
                      .guides = {},
                      .panel_height = shares_height,
                      .label_room = label_room},
                     width);
}

// ---- of pixels

// 1 - s E_j / I_j of each pixel, by luminance; not known where there is no light.
PixelMap share_map(const Rendering& run) {
  const FilmEstimate of_samples = averaged(part_of_samples(run)), all = averaged(run.film);
  const ImageShape shape(all.shape);
  PixelMap map{shape.width, shape.height, {}};
  for (std::size_t i = 0; i < shape.pixels(); ++i) {
    const auto light = [&](const FilmEstimate& film) {
      const double* pixel = &film.value[i * shape.channels];
      return shape.channels == 3 ? luminance(std::array{pixel[0], pixel[1], pixel[2]}) : pixel[0];
    };
    map.values.push_back(light(all) > 0 ? std::clamp(1 - light(of_samples) / light(all), 0.0, 1.0)
                                        : not_known);
  }
  return map;
}

}  // namespace

std::string parts_of_film(const Rendering& run, const PartsFigureOptions& options) {
  const double page_width = options.width.value_or(style::page_width),
               width = block_width(page_width);
  const std::vector<Bar> all = bars_of(run.film, options.axes.extent),
                         of_samples = bars_of(part_of_samples(run), options.axes.extent);
  std::vector<Block> blocks{film_chart(all, of_samples, options.axes, width),
                            share_chart(all, of_samples, options.axes, width)};
  for (Block& block : class_bars(run, width)) blocks.push_back(std::move(block));
  return page(options.title, summary(run), page_width, blocks);
}

std::string parts_of_image(const Rendering& run, const PartsFigureOptions& options) {
  const double page_width = options.width.value_or(style::page_width),
               width = block_width(page_width);
  const double white = white_of(run.film) / std::exp2(options.exposure);
  const std::string share = percent(pooling_of(run).light_of_samples),
                    rest = percent(1 - pooling_of(run).light_of_samples);
  std::vector<Block> blocks{
      panel_row(picture_panel({"what samples carry", share + " of the light"}, part_of_samples(run),
                              options.value, white),
                picture_panel({"what chains carry", rest + " of the light"}, part_of_chains(run),
                              options.value, white),
                width),
      panel_row(
          picture_panel({"both", "the film of " + run.method}, run.film, options.value, white),
          share_panel({"the share of chains", "what samples seldom find"}, share_map(run)), width)};
  for (Block& block : class_bars(run, width)) blocks.push_back(std::move(block));
  return page(options.title, summary(run), page_width, blocks);
}

}  // namespace wander::figure
