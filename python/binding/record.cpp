#include "python/binding/record.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/film_statistics.h"
#include "draw/figure/film_figure.h"
#include "draw/figure/image_figure.h"
#include "draw/figure/parts_figure.h"
#include "lab/checkpoint.h"
#include "lab/failure.h"
#include "lab/scene_source.h"
#include "python/binding/arrays.h"
#include "python/binding/bindings.h"
#include "records/csv.h"
#include "records/run_files.h"
#include "records/run_json.h"
#include "records/tone.h"
#include "tools/output_place.h"
#include "tools/plot_image.h"
#include "tools/summary.h"

namespace wander::python {

namespace nb = nanobind;

namespace {

BoundRecord read(const std::string& path) {
  return {std::make_shared<const RunRecord>(read_run(path))};
}

// All but the numbers of films.
std::string json_of(const BoundRecord& record) {
  const FilmEstimate& film = record.run->rendering.film;
  nlohmann::ordered_json shape{{"shape", film.shape}};
  return to_json(*record.run, std::move(shape))
      .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// Of a run in the plane, whose scene is its text.
description::Scene scene_of(const BoundRecord& record) {
  return parse_scene(record.run->provenance.scene_text, record.run->provenance.scene_name).scene;
}

std::string plane_figure(const BoundRecord& record, std::optional<double> width) {
  const description::Scene scene = scene_of(record);
  return figure::film_figure({{record.run->rendering.method, record.run->rendering}},
                             {.title = record.run->provenance.scene_name,
                              .axes = figure::film_axes(scene),
                              .inset = scene,
                              .reference = std::nullopt,
                              .width = width});
}

std::string figure_of(const BoundRecord& record, std::optional<double> width) {
  if (record.run->provenance.dimension == 2) return plane_figure(record, width);
  return figure::image_figure(
      {{record.run->rendering.method, record.run->rendering}},
      {.title = record.run->provenance.scene_name, .value = value_of(*record.run), .width = width});
}

// What its film is of, and where the bins of a row lie; no files of its scene are asked for.
nb::typed<nb::dict, nb::str, nb::any> axes_of(const BoundRecord& record) {
  nb::typed<nb::dict, nb::str, nb::any> axes;
  if (record.run->provenance.dimension == 2) {
    const description::Scene scene = scene_of(record);
    axes["position"] = quantity_of(figure::film_axes(scene).position);
    axes["value"] = quantity_of(figure::film_axes(scene).value);
    axes["centers"] = bin_centers(scene);
  } else {
    axes["value"] = quantity_of(value_of(*record.run));
  }
  return axes;
}

// ---- films

BoundFilm film_of(const BoundRecord& record) { return {record.run, &record.run->rendering.film}; }

std::optional<BoundFilm> chains_film_of(const BoundRecord& record) {
  const auto& film = record.run->rendering.chains_film;
  if (!film) return std::nullopt;
  return BoundFilm{record.run, &*film};
}

std::optional<Array> film_of_samples(const BoundRecord& record) {
  const Rendering& rendering = record.run->rendering;
  if (!rendering.pooling || rendering.pooling->film_of_samples.empty()) return std::nullopt;
  return array_of(rendering.pooling->film_of_samples, rendering.film.shape, record.run);
}

// Of a film that has none, such as that of the chains of a large one, None.
std::optional<Array> numbers_of(const BoundFilm& film, const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  return array_of(numbers, film.film->shape, film.owner);
}

std::optional<Flags> reliable_of(const BoundFilm& film) {
  if (film.film->reliable.empty()) return std::nullopt;
  return flags_of(film.film->reliable, film.film->shape);
}

std::map<int, Array> lengths_of(const BoundFilm& film) {
  std::map<int, Array> lengths;
  for (const auto& [vertices, numbers] : film.film->by_length)
    lengths.emplace(vertices, array_of(numbers, film.film->shape, film.owner));
  return lengths;
}

// As film.png shows it.
using Bytes = nb::ndarray<nb::numpy, std::uint8_t>;
Bytes srgb_of(const BoundFilm& film, double exposure) {
  const double white = white_of(*film.film) / std::exp2(exposure);
  auto bytes =
      std::make_shared<const std::vector<std::uint8_t>>(srgb_bytes(film.film->value, white));
  const std::vector<std::size_t> sizes = extents(film.film->shape);
  auto* first = const_cast<std::uint8_t*>(bytes->data());  // nobody else has them
  return {first, sizes.size(), sizes.data(), kept_alive(bytes)};
}

// Arrays say themselves what keeps them: hence rv_policy::automatic.
void bind_film(nb::module_& module) {
  nb::class_<BoundFilm>(module, "Film", "Value and error of each number of a film.")
      .def_prop_ro(
          "value", [](const BoundFilm& f) { return numbers_of(f, f.film->value); },
          nb::rv_policy::automatic)
      .def_prop_ro(
          "standard_error",
          [](const BoundFilm& f) { return numbers_of(f, f.film->standard_error); },
          nb::rv_policy::automatic)
      .def_prop_ro("reliable", &reliable_of, nb::rv_policy::automatic)
      .def_prop_ro("by_length", &lengths_of, nb::rv_policy::automatic)
      .def("srgb", &srgb_of, nb::arg("exposure"), "As film.png shows it.")
      .def_prop_ro("degrees_of_freedom",
                   [](const BoundFilm& f) { return f.film->degrees_of_freedom; })
      .def_prop_ro("relative_error", [](const BoundFilm& f) { return relative_error(*f.film); });
}

}  // namespace

nb::dict quantity_of(const figure::Quantity& quantity) {
  nb::dict dict;
  dict["name"] = quantity.name;
  dict["unit"] = quantity.unit;
  return dict;
}

void write_record(const BoundRecord& record, const std::string& directory, bool replaces,
                  double exposure) {
  Global place;
  place.force = replaces;
  require_replaceable_directory(directory, place, "or say overwrite=True to replace it");
  const OutputDirectory output(directory, place);
  const bool is_row = record.run->provenance.dimension == 2;
  write_run(*record.run, is_row ? scene_of(record) : description::Scene{}, output.path(), exposure);
}

// A record that nothing can carry on; a checkpoint that lay there is of another film.
void write_finished(const BoundRecord& record, const std::string& directory, bool replaces,
                    double exposure) {
  write_record(record, directory, replaces, exposure);
  remove_file(checkpoint_in(directory));
}

void bind_record(nb::module_& module) {
  bind_film(module);
  nb::class_<BoundRecord>(module, "Record", "What a run computed, and what made it.")
      .def_static("read", &read, nb::arg("path"), "The directory of a run, or a file of it.")
      .def_prop_ro("json", &json_of, "run.json without the numbers of films.")
      .def("axes", &axes_of, "What its film is of.")
      .def_prop_ro("film", &film_of)
      .def_prop_ro("chains_film", &chains_film_of, "Of the chains alone, where the film is pooled.")
      .def_prop_ro("film_of_samples", &film_of_samples, nb::rv_policy::automatic,
                   "What of a pooled film samples carry.")
      .def_prop_ro("summary", [](const BoundRecord& r) { return summary_of(r.run->rendering); })
      .def("figure", &figure_of, nb::arg("width").none(), "An SVG document.")
      .def("write", &write_finished, nb::arg("directory"), nb::arg("overwrite"),
           nb::arg("exposure"));
}

}  // namespace wander::python
