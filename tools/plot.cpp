// `wander plot`: a scene, films, a comparison, a trajectory or the light in a scene as a figure.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "draw/figure/scene_figure.h"
#include "draw/figure/space_figure.h"
#include "draw/figure/style.h"
#include "draw/report/error_figure.h"
#include "lab/compare/comparison_json.h"
#include "lab/failure.h"
#include "lab/nearest.h"
#include "lab/parsing.h"
#include "lab/scene_source.h"
#include "records/trajectory_netcdf.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/figure_file.h"
#include "tools/output_place.h"
#include "tools/plot_film.h"
#include "tools/plot_fluence.h"
#include "tools/plot_image.h"
#include "tools/plot_parts.h"
#include "tools/plot_trajectory.h"
#include "tools/verb.h"

namespace wander {

namespace {

struct Figure {
  const char* kind;
  std::string text;  // SVG, or the lines of an OBJ file
};

// Of paths in space, and no figure.
bool is_of_lines(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return ending == ".obj" || ending == ".OBJ";
}

std::string scene_svg(const PlotOptions& options) {
  const std::string& file = options.files.front();
  if (!is_scene(file)) require_no_directory(file);
  const description::Scene scene = open_scene(file).scene;
  if (options.files.size() > 1)
    throw UsageError(shown_name(file) + " is a scene; scenes are drawn one at a time");
  if (!options.reference.empty())
    throw UsageError("--reference is drawn into films, and " + shown_name(file) + " is a scene");
  const figure::SceneFigureOptions how{
      .title = options.title.value_or(scene.name),
      .width = options.width.value_or(figure::style::column_width)};
  return scene.dimension == 2 ? figure::scene_figure(scene, how) : figure::space_figure(scene, how);
}

// Its films are drawn by report.html, beside which it lies.
std::string comparison_svg(const compare::Comparison& comparison, const PlotOptions& options) {
  if (options.files.size() > 1 || !options.reference.empty())
    throw UsageError(options.files.front() +
                     " is a comparison; comparisons are drawn one at a time, and without "
                     "--reference");
  return report::error_time_figure(comparison, options.title.value_or("Error against time"),
                                   options.width.value_or(figure::style::page_width));
}

void require_linear(const PlotOptions& options, const char* what) {
  if (options.values == figure::Spacing::logarithmic)
    throw UsageError(
        fmt::format("--log-y is for films, and {} is {}", options.files.front(), what));
}

void require_no_exposure(const PlotOptions& options, const char* what) {
  if (options.exposure)
    throw UsageError(
        fmt::format("--exposure is for images, and {} is {}", options.files.front(), what));
}

Figure figure_of_trajectory(const TrajectoryRecord& record, const PlotOptions& options,
                            const Global& global) {
  require_linear(options, "a trajectory");
  return {"trajectory", is_of_lines(global.out) ? trajectory_obj(record, options)
                                                : trajectory_svg(record, options)};
}

// Which kind of file the first one is decides; a scene is what is nothing else.
Figure figure_of(const PlotOptions& options, const Global& global) {
  if (options.parts) return {"parts", parts_svg(options)};
  const std::string& file = options.files.front();
  std::error_code unreachable;
  const bool is_file = !is_scene(file) && std::filesystem::is_regular_file(file, unreachable);
  if (is_file)
    if (const auto record = find_trajectory(file))
      return figure_of_trajectory(*record, options, global);
  if (is_of_lines(global.out))
    throw UsageError(
        fmt::format("{}: the lines of a trajectory in space, and {} is none; a figure "
                    "is SVG, PNG or PDF, and its name ends in .svg, .png or .pdf",
                    global.out.string(), file));
  if (!options.trajectory.is_empty())
    throw UsageError(file +
                     " is no trajectory, which --figure, --draws, --chain, --mutation and --class "
                     "are for; `wander trace` records one");
  if (!is_scene(file))
    if (const auto comparison = compare::find_comparison(file)) {
      require_no_exposure(options, "a comparison");
      return {"comparison", comparison_svg(*comparison, options)};
    }
  if (std::optional<Film> film = find_film(file))
    return {"film",
            film->is_image() ? image_svg(*std::move(film), options) : film_svg(*film, options)};
  if (is_file && std::filesystem::path(file).extension() == ".csv")
    throw UsageError(file +
                     " is a table for other programs; a figure is drawn of the folder that it lies "
                     "in, as `wander plot RUN -o FILE`");
  require_linear(options, "a scene");
  require_no_exposure(options, "a scene");
  return {"scene", scene_svg(options)};
}

void require_sensible(const PlotOptions& options, const Global& global) {
  if (global.out.empty()) throw UsageError("plot needs -o FIGURE.svg, .png or .pdf");
  const FluencePlotOptions& fluence = options.fluence;
  if (!fluence.wanted && (fluence.budget || fluence.resolution))
    throw UsageError("--budget and --resolution are for --fluence");
  if (fluence.wanted &&
      (!options.trajectory.is_empty() || !options.reference.empty() || options.exposure ||
       options.parts || options.values == figure::Spacing::logarithmic))
    throw UsageError(
        "--fluence is of a scene alone: no option of films or trajectories goes "
        "with it");
}

void require_ending(const PlotOptions& options, const Global& global) {
  if (!is_of_lines(global.out))
    figure_file(global.out, options.dpi, ", or .obj for the paths of a trajectory in space");
  else if (options.dpi)
    throw UsageError(fmt::format("--dpi is for FILE.png; {} has no pixels", global.out.string()));
}

// What is drawn is read, and with it its faults are found; misread words are not taken for files.
void examine(PlotOptions& options, const Global& global, Figure& figure, Examination& examination) {
  const bool words_are_known = examination.is_passed();
  examination.part([&] { require_sensible(options, global); });
  examination.part([&] {
    require_replaceable(global.out, global);
    require_apart(global.out, options.files);
    require_apart(global.out, std::span(&options.reference, 1));
  });
  if (!global.out.empty() && !options.fluence.wanted)
    examination.part([&] { require_ending(options, global); });
  if (words_are_known && !options.fluence.wanted)
    examination.part([&] { figure = figure_of(options, global); });
}

ExitCode plot(const PlotOptions& options, const Global& global, const Figure& figure) {
  if (options.fluence.wanted) return plot_fluence(options, global);
  if (is_of_lines(global.out))
    write_output(global.out, figure.text);
  else
    write_figure(figure_file(global.out, options.dpi), figure.text);
  if (global.json)
    print_json({{"schema", "wanderlight-plot/1"},
                {"kind", figure.kind},
                {"figure", global.out.string()},
                {"files", options.files}});
  return ExitCode::ok;
}

template <class Choice, std::size_t count>
Choice parse_choice(std::string_view kind, std::string_view text,
                    const std::array<std::string_view, count>& words,
                    const std::array<Choice, count>& choices) {
  const auto found = std::ranges::find(words, text);
  if (found == words.end()) throw UsageError(unknown_word(kind, text, words));
  return choices[static_cast<std::size_t>(found - words.begin())];
}

figure::Layout parse_layout(std::string_view text) {
  using enum figure::Layout;
  return parse_choice<figure::Layout, 3>("layout", text, layout_words,
                                         {automatic, overlay, panels});
}

TrajectoryFigure parse_figure(std::string_view text) {
  using enum TrajectoryFigure;
  return parse_choice<TrajectoryFigure, 6>(
      "figure", text, figure_words, {paths, trace, acceptance, autocorrelation, density, all});
}

DrawRange parse_draws(std::string_view text) {
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  const auto [first, end] = parse_pair("--draws", text);
  if (first >= end)
    throw UsageError(
        fmt::format("--draws {}: allowed is A:B with A below B, the draws from A up to "
                    "B, not included",
                    text));
  return {static_cast<int>(std::min(first, most)), static_cast<int>(std::min(end, most))};
}

void add_film_options(Command verb, const std::shared_ptr<PlotOptions>& options) {
  verb.add_option("--reference", options->reference,
                  "draw this run into every film as a thin line; hold every image against it")
      .type_name("RUN");
  verb.add_option(
          "--layout", [options](const std::string& text) { options->layout = parse_layout(text); },
          "how several films share the figure: overlay, panels, or auto (the default: two films "
          "are overlaid where both can be followed, all others have panels)")
      .type_name("HOW");
  verb.add_flag(
      "--log-y", [options] { options->values = figure::Spacing::logarithmic; },
      "of films: a logarithmic axis of values (that of errors always is)");
  verb.add_option(
          "--exposure",
          [options](const std::string& text) { options->exposure = parse_exposure(text); },
          "of images, in stops: +1 is twice as bright (default: 0, with which 99 % of the pixels "
          "that have light are not above white)")
      .type_name("EV");
}

void add_parts_option(Command verb, const std::shared_ptr<PlotOptions>& options) {
  verb.add_flag("--parts", options->parts,
                "of a run of chains: what of its film, and of the light of each class of path, "
                "independent samples carry and what is left to the chains");
}

void add_page_options(Command verb, const std::shared_ptr<PlotOptions>& options) {
  verb.add_option(
          "--width",
          [options](const std::string& text) { options->width = parse_figure_width(text); },
          "how wide the figure is on the page, in mm, cm, in, pt or px, such as 84mm for a column; "
          "it is laid out for that width, and its words keep their size")
      .type_name("LENGTH");
  verb.add_option(
          "--dpi",
          [options](const std::string& text) { options->dpi = parse_resolution("--dpi", text); },
          "of FILE.png: pixels to the inch (default: 300)")
      .type_name("N");
}

void add_trajectory_options(Command verb, const std::shared_ptr<PlotOptions>& options) {
  verb.add_option(
          "--figure",
          [options](const std::string& text) { options->trajectory.figure = parse_figure(text); },
          "of a trajectory: paths, trace, acceptance, autocorrelation, density, or all (the "
          "default)")
      .type_name("WHICH");
  verb.add_option(
          "--draws",
          [options](const std::string& text) { options->trajectory.draws = parse_draws(text); },
          "only the draws from A up to, not including, B")
      .type_name("A:B");
  verb.add_option(
          "--chain",
          [options](const std::string& text) {
            options->trajectory.chain =
                static_cast<int>(parse_count("--chain", text, 0, std::numeric_limits<int>::max()));
          },
          "only this chain (the paths are of the first one)")
      .type_name("K");
  verb.add_option("--mutation", options->trajectory.mutation,
                  "paths, acceptance and density: only steps of this mutation")
      .type_name("NAME");
  verb.add_option("--class", options->trajectory.path_class,
                  "the same: only steps from or to paths of this class, such as LDSE")
      .type_name("CLASS");
}

void add_fluence_options(Command verb, const std::shared_ptr<PlotOptions>& options) {
  verb.add_flag("--fluence", options->fluence.wanted,
                "of a scene: the light in the space between the surfaces, as a figure or FILE.exr");
  verb.add_option(
          "-b,--budget",
          [options](const std::string& text) { options->fluence.budget = parse_budget(text); },
          "how much to compute for it: walks of light (2M) or seconds (30s, 30cpu-s; default: 5s)")
      .type_name("BUDGET");
  verb.add_option(
          "--resolution",
          [options](const std::string& text) {
            options->fluence.resolution =
                static_cast<int>(parse_count("--resolution", text, 1, 1 << 16));
          },
          "cells across its picture (default: 256)")
      .type_name("W");
}

constexpr const char* plot_details = R"(
A scene is drawn with its lights (red, rays on the side that shines), its sensor (blue, pins on
the side that listens) and its materials.  Films are drawn with 95 % intervals; bins that are not
reliable are hatched.  Several runs share one figure.  Images stand beside maps of their relative
error; beside an image that is held against another, the --reference or the second of two, stands
their difference in units of the standard error of both.  Scenes in space are drawn as the outline
that their camera has of them, with what is hidden.  Of a comparison the error is drawn against time, with the times from which on one contender is ahead of another.  Of a trajectory the first
steps are drawn one by one: the current path black, accepted proposals solid, rejected ones dashed,
failed ones dotted as far as they came; in the plane, moves too small to be seen are enlarged.
The fluence is the integral of radiance over all directions, in W/m; the image has it as channel Y,
with standard_error.Y.
In space the paths are drawn over the outline of the scene, or over an image of it, which is then the
second FILE.
The ending says what the figure is: .svg, .png (300 dpi) or .pdf; of a trajectory in space also .obj,
its paths as lines (objects start, accepted, rejected and failed), which Blender opens.

Examples:
  wander plot scene.json -o scene.svg
  wander plot run_mlt run_bdpt --reference long_run -o films.svg
  wander plot run_mlt run_bdpt --width 84mm -o films.pdf
  wander plot image_mlt image_bdpt --exposure 1 -o images.png
  wander plot run_mlt --parts -o parts.svg
  wander plot comparison -o error.svg
  wander plot trace.nc --figure paths --chain 2 --draws 100:112 -o paths.svg
  wander plot trace3d.nc image_mlt --figure paths -o paths3d.svg
  wander plot trace3d.nc --draws 0:500 -o paths3d.obj
  wander plot scene.json --fluence -b 2M -o light.svg
)";

}  // namespace

void add_plot(CLI::App& app, Global& global) {
  auto options = std::make_shared<PlotOptions>();
  Command verb =
      add_verb(app, "plot", "draw a scene, films, a comparison, a trajectory or light as a figure");
  verb.add_option("FILE", options->files,
                  "a scene file, gallery:NAME, - (a scene from standard input), runs (directory, "
                  "run.json, film.exr or film.nc), a "
                  "comparison (directory or compare.json), or a trajectory (FILE.nc)")
      .required();
  verb.add_option("--title", options->title, "instead of the name of the scene").type_name("TEXT");
  add_page_options(verb, options);
  add_film_options(verb, options);
  add_parts_option(verb, options);
  add_trajectory_options(verb, options);
  add_fluence_options(verb, options);
  add_global_options(verb, global);
  verb.footer(plot_details);
  auto figure = std::make_shared<Figure>();
  examine_with(verb, global, [options, figure, &global](Examination& examination) {
    examine(*options, global, *figure, examination);
  });
  verb.callback([options, figure, &global] {
    global.job = [options, figure, &global] { return plot(*options, global, *figure); };
  });
}

}  // namespace wander
