#include "tools/plot_fluence.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "draw/figure/fluence_figure.h"
#include "draw/figure/plane_picture.h"
#include "lab/failure.h"
#include "lab/fluence.h"
#include "lab/scene_source.h"
#include "lab/wording.h"
#include "records/atomic_file.h"
#include "records/exr.h"
#include "statistics/number_text.h"
#include "tools/console.h"
#include "tools/figure_file.h"
#include "tools/interruption.h"
#include "tools/output_place.h"
#include "tools/progress.h"

namespace wander {

namespace {

constexpr int default_resolution = 256;
constexpr int most_cells = 1 << 22;

// None: an image.
std::optional<FigureFile> figure_for(const PlotOptions& options, const Global& global) {
  if (global.out.extension() != ".exr")
    return figure_file(global.out, options.dpi, ", or in .exr for an image of numbers");
  if (options.width || options.dpi)
    throw UsageError(
        fmt::format("--width and --dpi are for figures; {} has as many pixels as "
                    "--resolution says",
                    global.out.string()));
  return std::nullopt;
}

SceneDocument scene_for(const PlotOptions& options) {
  if (options.files.size() > 1) throw UsageError("--fluence is computed for one scene at a time");
  const std::string& file = options.files.front();
  SceneDocument document = open_scene(file);
  if (document.scene.dimension != 2)
    throw UsageError(file + ": --fluence is for two-dimensional scenes");
  return document;
}

PlaneGrid grid_for(const description::Scene& scene, const PlotOptions& options) {
  const PlaneGrid grid =
      figure::grid_over(scene, options.fluence.resolution.value_or(default_resolution));
  if (grid.size() > most_cells)
    throw UsageError(
        fmt::format("the picture would have {} x {} cells; a smaller --resolution "
                    "makes at most {} of them",
                    grid.columns(), grid.rows(), most_cells));
  return grid;
}

Rendering picture_of(const description::Scene& scene, const PlaneGrid& grid,
                     const PlotOptions& options, const Global& global) {
  Progress progress(global);
  const Session session{.budget = options.fluence.budget.value_or(TimeBudget{5}),
                        .seed = global.seed,
                        .threads = global.threads,
                        .interrupted = &watch_for_interruption(),
                        .report = progress.reporter()};
  return estimate_fluence(scene, grid, session);
}

std::string image(const SceneDocument& document, const PlaneGrid& grid, const Rendering& picture,
                  const Global& global) {
  return to_exr({picture, provenance_of(document, global.command_line)},
                {{grid.low().x, grid.low().y}, {grid.high().x, grid.high().y}});
}

}  // namespace

ExitCode plot_fluence(const PlotOptions& options, const Global& global) {
  const std::optional<FigureFile> figure = figure_for(options, global);
  const SceneDocument document = scene_for(options);
  const PlaneGrid grid = grid_for(document.scene, options);
  const Rendering picture = picture_of(document.scene, grid, options, global);
  if (figure)
    write_figure(*figure, figure::fluence_figure(document.scene, grid, picture,
                                                 options.title.value_or(document.scene.name),
                                                 options.width.value_or(figure::fluence_width)));
  else
    write_file(global.out, image(document, grid, picture, global));
  if (!global.quiet)
    print_note(
        fmt::format("fluence: {} of light, {} x {} cells from ({}, {}) to "
                    "({}, {}) m, {}{}\n",
                    counted_in_words(picture.samples, "walk"), grid.columns(), grid.rows(),
                    number_text(grid.low().x, 6), number_text(grid.low().y, 6),
                    number_text(grid.high().x, 6), number_text(grid.high().y, 6),
                    duration_in_words(picture.seconds), picture.complete ? "" : ", interrupted"));
  if (global.json)
    print_json({{"schema", "wanderlight-plot/1"},
                {"kind", "fluence"},
                {"figure", global.out.string()},
                {"files", options.files},
                {"samples", picture.samples},
                {"shape", picture.film.shape},
                {"low", {grid.low().x, grid.low().y}},
                {"high", {grid.high().x, grid.high().y}}});
  return picture.complete ? ExitCode::ok : ExitCode::interrupted;
}

}  // namespace wander
