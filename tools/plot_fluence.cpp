#include "tools/plot_fluence.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/fluence.h"
#include "core/number_text.h"
#include "core/output/atomic_file.h"
#include "core/output/exr.h"
#include "core/output/version.h"
#include "tools/console.h"
#include "tools/failure.h"
#include "tools/figure/fluence_figure.h"
#include "tools/figure/plane_picture.h"
#include "tools/interruption.h"
#include "tools/output_place.h"
#include "tools/progress.h"
#include "tools/scene_source.h"
#include "tools/wording.h"

namespace wander {

namespace {

constexpr int default_resolution = 256;
constexpr int most_cells = 1 << 22;

enum class Form { svg, exr };

Form form_of(const std::filesystem::path& out) {
  if (out.extension() == ".svg") return Form::svg;
  if (out.extension() == ".exr") return Form::exr;
  throw UsageError(
      fmt::format("{}: the picture of fluence is a figure, FILE.svg, or an image, "
                  "FILE.exr",
                  out.string()));
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

std::string image(const SceneDocument& document, const Rendering& picture, const Global& global) {
  return to_exr({picture,
                 {.scene_name = document.scene.name,
                  .scene_text = document.text,
                  .scene_sha256 = document.sha256,
                  .dimension = document.scene.dimension,
                  .command_line = global.command_line,
                  .version = program_version()}});
}

}  // namespace

ExitCode plot_fluence(const PlotOptions& options, const Global& global) {
  const Form form = form_of(global.out);
  const SceneDocument document = scene_for(options);
  const PlaneGrid grid = grid_for(document.scene, options);
  const Rendering picture = picture_of(document.scene, grid, options, global);
  write_file(global.out, form == Form::exr
                             ? image(document, picture, global)
                             : figure::fluence_figure(document.scene, grid, picture,
                                                      options.title.value_or(document.scene.name)));
  if (!global.quiet)
    print_note(
        fmt::format("fluence: {} walks of light, {} x {} cells from ({}, {}) to "
                    "({}, {}) m, {}{}\n",
                    count_in_words(static_cast<double>(picture.samples)), grid.columns(),
                    grid.rows(), number_text(grid.low().x, 6), number_text(grid.low().y, 6),
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
