#include "lab/compare/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/exact/diffuse_film.h"
#include "core/film_statistics.h"
#include "core/image_shape.h"
#include "core/requirements.h"
#include "core/tint.h"
#include "lab/failure.h"
#include "lab/reference_doubts.h"
#include "lab/reference_name.h"
#include "lab/wording.h"
#include "records/run_json.h"
#include "statistics/number_text.h"

namespace wander::compare {

namespace {

// A film whose own error, relative to itself, is above this part is no exact answer.
constexpr double largest_exact_error = 1e-3;

std::size_t bins_of(const std::vector<int>& shape) {
  std::size_t bins = 1;
  for (const int extent : shape) bins *= static_cast<std::size_t>(extent);
  return bins;
}

// A file may hold anything.
void require_sound(const std::filesystem::path& file, const FilmEstimate& film) {
  const auto refuse = [&](const std::string& fault) {
    throw RunFileError(fmt::format(
        "--reference {}: {}; give a film.exr, film.nc, run.json or reference.json as the "
        "program wrote it, or leave --reference out",
        file.string(), fault));
  };
  if (film.value.size() != bins_of(film.shape))
    refuse(fmt::format("its film of {} has {} values", extent_in_words(film.shape),
                       film.value.size()));
  const auto broken =
      std::ranges::count_if(film.value, [](double value) { return !std::isfinite(value); });
  if (broken > 0)
    refuse(fmt::format("{} of {} values of its film are no numbers", broken, film.value.size()));
  if (std::ranges::any_of(film.standard_error, [](double error) { return error < 0; }))
    refuse("a standard error of its film is below zero");
}

[[noreturn]] void refuse_shape(const std::filesystem::path& file, const FilmEstimate& film,
                               const std::vector<int>& shape) {
  const auto channels = [&](std::span<const int> extents) {
    return is_image(shape) && channels_of(extents) == 1 ? " in one channel" : "";
  };
  const std::string message = fmt::format(
      "--reference {}: its film has {}{}{}, that of the scene {}{}; give a film of the same shape",
      file.string(), extent_in_words(film.shape), channels(film.shape),
      film.value.empty() ? " without values" : "", extent_in_words(shape), channels(shape));
  if (is_image(shape)) throw RunFileError(message);
  throw UsageError(message);
}

}  // namespace

Reference reference_from_file(const std::filesystem::path& file, const description::Scene& asked,
                              const Provenance& provenance, std::vector<std::string>& warnings) {
  RunRecord run = read_run(file);
  const FilmEstimate& film = run.rendering.film;
  const std::vector<int> shape = film_shape(asked);
  if (film.value.empty() || film.shape != shape) refuse_shape(file, film, shape);
  require_sound(file, film);
  if (!may_be_the_same(run.provenance.scene_digest, provenance.scene_digest))
    warnings.push_back(
        fmt::format("--reference {} {}: errors are measured against that scene's film",
                    file.string(), doubt_of_another_scene));
  if (has_other_lengths(run.rendering, asked.max_vertices))
    warnings.push_back(fmt::format("--reference {} has {}", file.string(),
                                   words_of_lengths(run.rendering, asked.max_vertices)));
  if (!run.rendering.complete)
    warnings.push_back(
        fmt::format("--reference {} is of a run that was interrupted", file.string()));
  std::vector<std::uint64_t> seeds;
  if (may_be_the_same(run.provenance.scene_digest, provenance.scene_digest))
    seeds = seeds_of(run.rendering);
  const std::string origin =
      fmt::format("{}{}, made by `{}`", is_exact(origin_of(run.rendering)) ? "exact: " : "",
                  file.string(), run.provenance.command_line);
  return {.film = std::move(run.rendering.film),
          .origin = origin,
          .max_vertices = run.rendering.max_vertices,
          .seeds = std::move(seeds)};
}

std::optional<Reference> exact_reference(const description::Scene& scene, std::string& why) {
  if (scene.dimension != 2) {
    why = "there is none of scenes in space";
    return std::nullopt;
  }
  exact::DiffuseFilm exact;
  try {
    exact = exact::diffuse_film(scene);
  } catch (const std::invalid_argument& problem) {
    why = problem.what();
    return std::nullopt;
  }
  FilmEstimate film;
  film.shape = {static_cast<int>(exact.value.size())};
  film.value = std::move(exact.value);
  film.standard_error = std::move(exact.error);
  film.reliable.assign(film.value.size(), true);
  film.degrees_of_freedom = std::numeric_limits<double>::infinity();
  const bool is_dark = std::ranges::all_of(film.value, [](double value) { return value == 0; });
  const double error = is_dark ? 0 : relative_error(film);
  if (!(error <= largest_exact_error)) {
    why = fmt::format("its error, {}, is too large", number_text(error, 1));
    return std::nullopt;
  }
  return Reference{
      std::move(film),
      fmt::format("exact: diffuse surfaces, solved as a linear system of {} unknowns to "
                  "a relative error of {}",
                  exact.unknowns, number_text(error, 1))};
}

Reference no_reference(const std::vector<int>& shape) {
  const std::size_t bins = bins_of(shape);
  FilmEstimate film{.shape = shape};
  film.value.assign(bins, not_known);
  film.standard_error.assign(bins, not_known);
  film.reliable.assign(bins, false);
  return {std::move(film), "none: the comparison was interrupted before there was one"};
}

}  // namespace wander::compare
