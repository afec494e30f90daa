// `wander plot`: a scene or films of two-dimensional scenes as an SVG figure.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/output/atomic_file.h"
#include "core/output/run_json.h"
#include "tools/console.h"
#include "tools/failure.h"
#include "tools/figure/film_figure.h"
#include "tools/figure/scene_figure.h"
#include "tools/nearest.h"
#include "tools/output_place.h"
#include "tools/scene_source.h"
#include "tools/verb.h"
#include "tools/wording.h"

namespace wander {

namespace {

struct PlotOptions {
  std::vector<std::string> files;
  std::string reference;
  std::optional<std::string> title;  // none: the name of the scene
  figure::Layout layout = figure::Layout::automatic;
};

// A run with what its figure needs to know of its scene.
struct Film {
  std::string path;
  RunRecord run;
  std::optional<description::Scene> scene;  // none if the run does not hold its text

  figure::FilmAxes axes() const { return scene ? figure::film_axes(*scene) : figure::FilmAxes{}; }
};

std::optional<Film> find_film(const std::string& path) {
  std::optional<RunRecord> run = path.starts_with(gallery_prefix) ? std::nullopt : find_run(path);
  if (!run) return std::nullopt;
  if (run->provenance.dimension != 2)
    throw UsageError(path +
                     ": plot draws films of two-dimensional scenes; this one is an image, "
                     "and film.exr holds it");
  if (run->rendering.film.value.empty())
    throw RunFileError(path + ": the run holds no film values");
  Film film{path, std::move(*run), std::nullopt};
  const std::string& text = film.run.provenance.scene_text;
  if (!text.empty()) film.scene = parse_scene(text, path).scene;
  return film;
}

Film require_film(const std::string& path) {
  if (std::optional<Film> film = find_film(path)) return std::move(*film);
  throw UsageError(path + " is not a run; only runs can be drawn together");
}

// Films over sensors of different kinds or lengths share no axis.
void require_same_axes(const Film& film, const Film& first) {
  const figure::FilmAxes a = film.axes(), b = first.axes();
  const double difference = std::abs(a.extent.high - b.extent.high);
  if (a.value.name != b.value.name || difference > 1e-9 * b.extent.high)
    throw UsageError(fmt::format("{} and {} have different sensors", film.path, first.path));
}

// "run" for run, run/, run/run.json and run/film.exr.
std::string short_name(const std::string& path) {
  std::filesystem::path name(path);
  if (!name.has_filename()) name = name.parent_path();
  const bool inside = name.filename() == "run.json" || name.filename() == "film.exr";
  if (inside && name.has_parent_path()) name = name.parent_path();
  return name.filename().string();
}

// The method, with the name of the run where two runs share a method.
std::string label_of(const Film& film, const std::vector<Film>& films) {
  const std::string& method = film.run.rendering.method;
  const auto same = std::count_if(films.begin(), films.end(), [&](const Film& other) {
    return other.run.rendering.method == method;
  });
  return same > 1 ? fmt::format("{} ({})", method, short_name(film.path)) : method;
}

figure::LabelledFilm reference_film(const Film& film) {
  const Rendering& rendering = film.run.rendering;
  return {fmt::format("{}, {} samples", rendering.method,
                      count_in_words(static_cast<double>(rendering.samples))),
          rendering};
}

std::string film_svg(const Film& first, const PlotOptions& options) {
  std::vector<Film> films{first};
  for (std::size_t k = 1; k < options.files.size(); ++k)
    films.push_back(require_film(options.files[k]));
  figure::FilmFigureOptions how{.title = options.title.value_or(first.run.provenance.scene_name),
                                .axes = first.axes(),
                                .inset = first.scene,
                                .reference = std::nullopt,
                                .layout = options.layout};
  std::vector<figure::LabelledFilm> labelled;
  for (const Film& film : films) {
    require_same_axes(film, first);
    labelled.push_back({label_of(film, films), film.run.rendering});
    // One drawing cannot stand for several scenes.
    if (film.run.provenance.scene_sha256 != first.run.provenance.scene_sha256) how.inset.reset();
  }
  if (!options.reference.empty()) {
    const Film reference = require_film(options.reference);
    require_same_axes(reference, first);
    how.reference = reference_film(reference);
  }
  return figure::film_figure(labelled, how);
}

std::string scene_svg(const PlotOptions& options) {
  const std::string& file = options.files.front();
  if (std::filesystem::is_directory(file))
    throw RunFileError(file + ": a directory without a run.json");
  const description::Scene scene = open_scene(file).scene;
  if (options.files.size() > 1)
    throw UsageError(file + " is a scene; scenes are drawn one at a time");
  if (!options.reference.empty())
    throw UsageError("--reference is drawn into films, and " + file + " is a scene");
  if (scene.dimension != 2) throw UsageError(file + ": plot draws two-dimensional scenes");
  return figure::scene_figure(scene, {.title = options.title.value_or(scene.name)});
}

ExitCode plot(const PlotOptions& options, const Global& global) {
  if (global.out.empty()) throw UsageError("plot needs -o FIGURE.svg");
  require_replaceable(global.out, global);
  const std::optional<Film> film = find_film(options.files.front());
  write_file(global.out, film ? film_svg(*film, options) : scene_svg(options));
  if (global.json)
    print_json({{"schema", "wanderlight-plot/1"},
                {"kind", film ? "film" : "scene"},
                {"figure", global.out.string()},
                {"files", options.files}});
  return ExitCode::ok;
}

figure::Layout parse_layout(std::string_view text) {
  constexpr std::array<std::string_view, 3> words{"auto", "overlay", "panels"};
  if (text == words[0]) return figure::Layout::automatic;
  if (text == words[1]) return figure::Layout::overlay;
  if (text == words[2]) return figure::Layout::panels;
  throw UsageError(unknown_word("layout", text, words));
}

constexpr const char* details =
    "\nA scene is drawn with its lights (red, rays on the side that shines), its sensor (blue, "
    "pins "
    "on\nthe side that listens) and its materials.  Films are drawn with 95 % intervals; bins that "
    "are not\nreliable are hatched.  Several runs share one figure.\n\n"
    "Examples:\n  wander plot scene.json -o scene.svg\n"
    "  wander plot run_mlt run_bdpt --reference long_run -o films.svg\n";

}  // namespace

void add_plot(CLI::App& app, Global& global) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* verb = app.add_subcommand("plot", "draw a scene or films as an SVG figure");
  verb->add_option("FILE", options->files,
                   "a scene file, gallery:NAME, or runs (directory, run.json or film.exr)")
      ->required();
  verb->add_option("--reference", options->reference,
                   "draw this run into every film as a thin line")
      ->type_name("RUN");
  verb->add_option("--title", options->title, "instead of the name of the scene")
      ->type_name("TEXT");
  verb->add_option_function<std::string>(
          "--layout", [options](const std::string& text) { options->layout = parse_layout(text); },
          "how several films share the figure: overlay, panels, or auto (the default: up to two "
          "films are overlaid)")
      ->type_name("HOW");
  add_global_options(*verb, global);
  verb->footer(details);
  verb->callback(
      [options, &global] { global.job = [options, &global] { return plot(*options, global); }; });
}

}  // namespace wander
