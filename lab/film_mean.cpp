#include "lab/film_mean.h"

#include <cmath>

namespace wander {

FilmEstimate mean_film(std::span<const WeightedFilm> films) {
  double total = 0;
  for (const WeightedFilm& each : films) total += each.weight;
  const std::size_t bins = films.front().film.value.size();
  FilmEstimate mean{.shape = films.front().film.shape};
  mean.value.resize(bins);
  mean.standard_error.resize(bins);
  mean.reliable.assign(bins, true);
  double variance = 0, spread = 0;  // Σ v and Σ v²/d of the films' variances over all bins
  for (const auto& [film, weight] : films) {
    const double share = weight / total;
    double of_film = 0;
    for (std::size_t j = 0; j < bins; ++j) {
      const double error = share * film.standard_error[j];
      mean.value[j] += share * film.value[j];
      mean.standard_error[j] = std::hypot(mean.standard_error[j], error);
      mean.reliable[j] = mean.reliable[j] && film.reliable[j];
      of_film += error * error;
    }
    variance += of_film;
    if (of_film > 0) spread += of_film * of_film / film.degrees_of_freedom;
    for (const auto& [vertices, values] : film.by_length) {
      auto& sum = mean.by_length[vertices];
      sum.resize(bins);
      for (std::size_t j = 0; j < bins; ++j) sum[j] += share * values[j];
    }
  }
  if (spread > 0)
    mean.degrees_of_freedom = variance * variance / spread;
  else
    for (const auto& each : films) mean.degrees_of_freedom += each.film.degrees_of_freedom;
  mean.degrees_of_error = mean.degrees_of_freedom;
  return mean;
}

}  // namespace wander
