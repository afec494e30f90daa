#include "mlt/run/normalized_film.h"

#include <algorithm>
#include <cmath>

#include "mlt/run/film_degrees.h"
#include "mlt/run/reliability.h"
#include "statistics/jackknife.h"

namespace wander {

namespace {

std::vector<std::vector<double>> films_of(std::span<const GroupFindings> groups) {
  std::vector<std::vector<double>> films;
  for (const GroupFindings& group : groups) {
    auto& film = films.emplace_back(group.film->weights());
    for (double& weight : film) weight *= group.scale;
  }
  return films;
}

double mass_of(const std::vector<std::vector<double>>& films) {
  double mass = 0;
  for (const auto& film : films)
    for (const double value : film) mass += value;
  return mass;
}

std::map<int, std::vector<double>> by_length(std::span<const GroupFindings> groups, double factor) {
  std::map<int, std::vector<double>> films;
  for (const GroupFindings& group : groups)
    for (const auto& [vertices, values] : group.film->lengths().scaled(factor * group.scale)) {
      auto& sum = films[vertices];
      sum.resize(values.size());
      for (std::size_t j = 0; j < values.size(); ++j) sum[j] += values[j];
    }
  return films;
}

}  // namespace

FilmEstimate normalized_film(std::span<const GroupFindings> groups, const Constant& constant,
                             std::vector<int> shape) {
  const std::vector<std::vector<double>> films = films_of(groups);
  const RatioJackknife jackknife(films, weights_of(groups));
  const auto bins = static_cast<double>(films.front().size());
  const auto lit = std::ranges::count_if(groups, [](const auto& g) { return g.scale > 0; });
  FilmEstimate film{.shape = std::move(shape)};
  FilmDegrees degrees(groups.size());
  for (std::size_t j = 0; j < films.front().size(); ++j) {
    const double value = constant.b.value * bins * jackknife.value(j);
    const double error = bins * jackknife.error(j, constant.without);
    film.value.push_back(value);
    film.standard_error.push_back(error);
    const double weight = degrees.add(value, error * error);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const double d =
          constant.without[g] * jackknife.without(j, g) / constant.b.value - jackknife.value(j);
      degrees.move_bin(g, bins * constant.b.value * d, weight);
    }
  }
  degrees.tell(film);
  film.reliable = reliability_of_groups(film, static_cast<std::size_t>(lit));
  film.by_length = by_length(groups, constant.b.value * bins / mass_of(films));
  return film;
}

}  // namespace wander
