#include "tools/plot_image.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "draw/figure/image_figure.h"
#include "lab/failure.h"
#include "lab/wording.h"

namespace wander {

namespace {

void require_same_shape(const Film& film, const Film& first) {
  const std::vector<int>&one = film.run.rendering.film.shape,
        &other = first.run.rendering.film.shape;
  if (one != other)
    throw UsageError(
        fmt::format("{} has {} and {} {}: images are drawn together if they have one "
                    "shape",
                    film.path, extent_in_words(one), first.path, extent_in_words(other)));
}

void require_options_of_images(const PlotOptions& options, const Film& first) {
  if (options.values == figure::Spacing::logarithmic)
    throw UsageError("--log-y is for rows of bins, and " + first.path + " is an image");
  if (options.layout != figure::Layout::automatic)
    throw UsageError("--layout is for rows of bins, and " + first.path + " is an image");
}

// Without copies: images are large.
std::vector<figure::LabelledFilm> labelled(std::vector<Film> films) {
  std::vector<figure::LabelledFilm> result;
  for (const Film& film : films) result.push_back({label_of(film, films), {}});
  for (std::size_t k = 0; k < films.size(); ++k)
    result[k].rendering = std::move(films[k].run.rendering);
  return result;
}

}  // namespace

figure::Quantity value_of(const RunRecord& run) {
  const auto scene = nlohmann::json::parse(run.provenance.scene_text, nullptr, false, true);
  if (!scene.is_object()) return {"value", ""};
  return scene.contains("camera") ? figure::Quantity{"mean radiance", "W/(m²·sr)"}
                                  : figure::Quantity{"mean irradiance", "W/m²"};
}

std::string image_svg(Film first, const PlotOptions& options) {
  require_options_of_images(options, first);
  std::vector<Film> others;
  for (std::size_t k = 1; k < options.files.size(); ++k)
    others.push_back(require_film(options.files[k], first));
  if (!options.reference.empty()) others.push_back(require_film(options.reference, first));
  for (const Film& film : others) require_same_shape(film, first);
  std::optional<Film> reference;
  if (!options.reference.empty()) {
    reference = std::move(others.back());
    others.pop_back();
  }
  others.insert(others.begin(), std::move(first));
  figure::ImageFigureOptions how{.title = options.title.value_or(title_of(others)),
                                 .value = value_of(others.front().run),
                                 .reference = std::nullopt,
                                 .exposure = options.exposure.value_or(0),
                                 .width = options.width};
  if (reference)
    how.reference = reference_film(*reference, others);
  else if (others.size() == 2)  // the first of which is held against the second
    warn_of_reference(others.back(), std::span(others).first(1));
  else
    warn_of_scenes(others);
  return figure::image_figure(labelled(std::move(others)), how);
}

}  // namespace wander
