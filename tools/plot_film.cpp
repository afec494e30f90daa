#include "tools/plot_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lab/failure.h"
#include "lab/reference_name.h"
#include "lab/scene_source.h"
#include "records/run_json.h"

namespace wander {

namespace {

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
  const Rendering& rendering = film.run.rendering;
  if (const std::string origin = origin_of(rendering); is_exact(origin)) return "exact";
  const std::string& method = rendering.method;
  const auto same = std::count_if(films.begin(), films.end(), [&](const Film& other) {
    return other.run.rendering.method == method;
  });
  return same > 1 ? fmt::format("{} ({})", method, short_name(film.path)) : method;
}

figure::LabelledFilm reference_film(const Film& film) {
  return {name_of_reference(film.run.rendering), film.run.rendering};
}

}  // namespace

std::optional<Film> find_film(const std::string& path) {
  std::optional<RunRecord> run = is_scene(path) ? std::nullopt : find_run(path);
  if (!run) return std::nullopt;
  if (run->provenance.dimension != 2)
    throw UsageError(path +
                     ": plot draws films of two-dimensional scenes; this one is an image, "
                     "and film.exr holds it");
  if (run->rendering.film.shape.size() > 1)
    throw UsageError(path +
                     ": this is a picture, such as --fluence computes, and no film; "
                     "viewers of OpenEXR show it");
  if (run->rendering.film.value.empty())
    throw RunFileError(path + ": the run holds no film values");
  Film film{path, std::move(*run), std::nullopt};
  const std::string& text = film.run.provenance.scene_text;
  if (!text.empty()) film.scene = parse_scene(text, path).scene;
  return film;
}

std::string film_svg(const Film& first, const PlotOptions& options) {
  std::vector<Film> films{first};
  for (std::size_t k = 1; k < options.files.size(); ++k)
    films.push_back(require_film(options.files[k]));
  figure::FilmFigureOptions how{.title = options.title.value_or(first.run.provenance.scene_name),
                                .axes = first.axes(),
                                .inset = first.scene,
                                .reference = std::nullopt,
                                .layout = options.layout,
                                .width = options.width,
                                .values = options.values};
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

}  // namespace wander
