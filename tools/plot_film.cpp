#include "tools/plot_film.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lab/failure.h"
#include "lab/reference_doubts.h"
#include "lab/reference_name.h"
#include "lab/scene_source.h"
#include "records/run_json.h"

namespace wander {

namespace {

// Films over sensors of different kinds or lengths share no axis.
void require_same_axes(const Film& film, const Film& first) {
  const figure::FilmAxes a = film.axes(), b = first.axes();
  const double difference = std::abs(a.extent.high - b.extent.high);
  if (a.value.name != b.value.name || difference > 1e-9 * b.extent.high)
    throw UsageError(fmt::format("{} and {} have different sensors; plot each by itself", film.path,
                                 first.path));
}

// "run" for run, run/, run/run.json and the films in it.
std::string short_name(const std::string& path) {
  std::filesystem::path name(path);
  if (!name.has_filename()) name = name.parent_path();
  const bool inside = name.filename() == "run.json" || name.filename() == "film.exr" ||
                      name.filename() == "film.nc";
  if (inside && name.has_parent_path()) name = name.parent_path();
  return name.filename().string();
}

}  // namespace

std::optional<Film> find_film(const std::string& path) {
  std::optional<RunRecord> run = is_scene(path) ? std::nullopt : find_run(path);
  if (!run) return std::nullopt;
  const bool is_image = run->provenance.dimension == 3;
  if (!is_image && run->rendering.film.shape.size() > 1)
    throw UsageError(path +
                     ": this is a picture, such as --fluence computes, and no film; "
                     "viewers of OpenEXR show it");
  if (run->rendering.film.value.empty())
    throw RunFileError(path + (is_image
                                   ? ": the run holds no film; the film.nc beside run.json has it"
                                   : ": the run holds no film values"));
  Film film{path, std::move(*run), std::nullopt};
  const std::string& text = film.run.provenance.scene_text;
  if (!text.empty() && !is_image) film.scene = parse_scene(text, path).scene;
  return film;
}

Film require_film(const std::string& path, const Film& first) {
  std::optional<Film> film = find_film(path);
  if (!film) throw UsageError(path + " is not a run; only runs can be drawn together");
  if (film->is_image() != first.is_image())
    throw UsageError(fmt::format("{} is an image and {} a row of bins: they share no figure",
                                 film->is_image() ? path : first.path,
                                 film->is_image() ? first.path : path));
  return *std::move(film);
}

std::string label_of(const Film& film, const std::vector<Film>& films) {
  const Rendering& rendering = film.run.rendering;
  if (const std::string origin = origin_of(rendering); is_exact(origin)) return "exact";
  const std::string& method = rendering.method;
  const auto same = std::count_if(films.begin(), films.end(), [&](const Film& other) {
    return other.run.rendering.method == method;
  });
  return same > 1 ? fmt::format("{} ({})", method, short_name(film.path)) : method;
}

void warn_of_reference(const Film& reference, std::span<const Film> films) {
  for (const Film& film : films)
    for (const std::string& doubt : doubts_of(reference.run, film.run))
      spdlog::warn("{} and its reference {}: {}", film.path, reference.path, doubt);
}

figure::LabelledFilm reference_film(const Film& film, std::span<const Film> others) {
  warn_of_reference(film, others);
  return {name_of_reference(film.run.rendering), film.run.rendering};
}

std::string title_of(std::span<const Film> films) {
  std::vector<std::string> names;
  for (const Film& film : films) {
    const std::string& name = film.run.provenance.scene_name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

void warn_of_scenes(std::span<const Film> films) {
  for (const Film& film : films)
    if (!may_be_the_same(film.run.provenance.scene_digest,
                         films.front().run.provenance.scene_digest))
      spdlog::warn("{} is of another scene than {}: each shows light of its own", film.path,
                   films.front().path);
}

std::string film_svg(const Film& first, const PlotOptions& options) {
  if (options.exposure)
    throw UsageError("--exposure is for images, and " + first.path + " is a row of bins");
  std::vector<Film> films{first};
  for (std::size_t k = 1; k < options.files.size(); ++k)
    films.push_back(require_film(options.files[k], first));
  warn_of_scenes(films);
  figure::FilmFigureOptions how{.title = options.title.value_or(title_of(films)),
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
    if (!may_be_the_same(film.run.provenance.scene_digest, first.run.provenance.scene_digest))
      how.inset.reset();
  }
  if (!options.reference.empty()) {
    const Film reference = require_film(options.reference, first);
    require_same_axes(reference, first);
    how.reference = reference_film(reference, films);
  }
  return figure::film_figure(labelled, how);
}

}  // namespace wander
