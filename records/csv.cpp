#include "records/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

namespace wander {

namespace {

std::vector<double> centers_along(double length, int bins) {
  std::vector<double> centers(static_cast<std::size_t>(bins));
  for (int i = 0; i < bins; ++i) centers[static_cast<std::size_t>(i)] = length * ((i + 0.5) / bins);
  return centers;
}

// Not every reader takes `-nan` for a number.
double without_sign_of_nan(double x) { return std::isnan(x) ? std::abs(x) : x; }

}  // namespace

std::vector<double> bin_centers(const description::Scene& scene) {
  if (scene.camera) return centers_along(1, scene.camera->resolution.at(0));
  for (const description::Shape& shape : scene.shapes)
    if (shape.sensor)
      return centers_along(
          description::visit_kind<2>([](const auto& kind) { return kind.length(); }, shape.kind),
          shape.sensor->resolution.at(0));
  throw std::logic_error("the scene has no sensor");
}

std::string to_csv(const FilmEstimate& film, const std::vector<double>& centers) {
  std::string text;
  write_csv(film, centers, [&text](std::string_view line) { text += line; });
  return text;
}

void write_csv(const FilmEstimate& film, const std::vector<double>& centers, const ByteSink& file) {
  file("bin,center,value,standard_error,reliable\n");
  std::string line;
  for (std::size_t i = 0; i < film.value.size(); ++i) {
    line.clear();
    fmt::format_to(std::back_inserter(line), "{},{},{},{},{:d}\n", i, centers.at(i),
                   without_sign_of_nan(film.value[i]),
                   without_sign_of_nan(film.standard_error.at(i)), film.reliable.at(i));
    file(line);
  }
}

}  // namespace wander
