#include "mlt/run/large_film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mlt/run/film_degrees.h"
#include "mlt/run/reliability.h"
#include "statistics/jackknife.h"

namespace wander {

namespace {

// All films of all runs, in their order.
class LightOfRuns {
 public:
  explicit LightOfRuns(std::span<const SharedLight> runs) : runs_(runs) {
    for (const SharedLight& run : runs) count_ += static_cast<std::size_t>(run.films->count());
  }

  std::size_t count() const { return count_; }
  std::vector<double> weights() const {
    std::vector<double> weights;
    for (const SharedLight& run : runs_)
      weights.insert(weights.end(), static_cast<std::size_t>(run.films->count()), run.weight);
    return weights;
  }
  std::size_t bins() const { return runs_.front().films->bins(); }
  // The light that each says falls on a bin.
  void at(std::size_t bin, std::vector<double>& light) const {
    light.clear();
    for (const SharedLight& run : runs_)
      for (std::size_t f = 0; f < static_cast<std::size_t>(run.films->count()); ++f)
        light.push_back(run.weight * run.scale * run.films->deposits(f, bin));
  }

 private:
  std::span<const SharedLight> runs_;
  std::size_t count_ = 0;
};

double pixels_in(const LightOfRuns& parts, std::span<const int> shape) {
  return static_cast<double>(parts.bins()) / channels_of(shape);
}

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

// The mean of all films of paths of each length, times `factor`.
std::map<int, std::vector<double>> by_length(std::span<const SharedLight> runs, double factor) {
  std::map<int, std::vector<double>> films;
  std::size_t count = 0;
  for (const SharedLight& run : runs) count += static_cast<std::size_t>(run.films->count());
  for (const SharedLight& run : runs)
    for (std::size_t n = 0; n < run.films->lengths(); ++n) {
      const std::vector<double> mean = run.films->mean_of_length(n);
      if (mean.empty()) continue;
      auto& film = films[static_cast<int>(n) + 2];
      film.resize(mean.size());
      const double weight =
          factor * run.weight * run.scale * run.films->count() / static_cast<double>(count);
      for (std::size_t j = 0; j < mean.size(); ++j) film[j] += weight * mean[j];
    }
  return films;
}

}  // namespace

FilmEstimate mean_film(const SharedLight& run, std::vector<int> shape) {
  const std::array runs{run};
  const LightOfRuns parts(runs);
  const double pixels = pixels_in(parts, shape), count = static_cast<double>(parts.count());
  FilmEstimate film{.shape = std::move(shape)};
  film.degrees_of_freedom = film.degrees_of_error = count - 1;
  make_room(film);
  std::vector<double> light;
  for (std::size_t j = 0; j < parts.bins(); ++j) {
    parts.at(j, light);
    const double mean = sum_of(light) / count;
    double squares = 0;
    for (const double x : light) squares += (x - mean) * (x - mean);
    const double error =
        count > 1 ? pixels * std::sqrt(squares / (count * (count - 1))) : not_known;
    film.value.push_back(pixels * mean);
    film.standard_error.push_back(error);
  }
  film.reliable = reliability_of_groups(film, parts.count());
  film.by_length = by_length(runs, pixels);
  return film;
}

std::vector<double> without_films(std::span<const SharedLight> runs, const Constant& constant) {
  const double b = constant.b.value;
  double total = 0;  // weight
  for (const SharedLight& run : runs) total += run.weight * run.films->groups();
  std::vector<double> without;
  std::size_t first = 0;
  for (const SharedLight& run : runs) {
    const SharedFilms& films = *run.films;
    for (int f = 0; f < films.count(); ++f) {
      double pull = 0, members = 0;
      for (int g = f; g < films.groups(); g += films.count(), ++members)
        pull += constant.without[first + static_cast<std::size_t>(g)] - b;
      without.push_back(b + (total - run.weight) / (total - members * run.weight) * pull);
    }
    first += static_cast<std::size_t>(films.groups());
  }
  return without;
}

FilmEstimate normalized_film(std::span<const SharedLight> runs, const Constant& constant,
                             std::vector<int> shape) {
  const LightOfRuns parts(runs);
  const std::vector<double> without = without_films(runs, constant), weights = parts.weights();
  const double pixels = pixels_in(parts, shape), b = constant.b.value;
  const int channels = channels_of(shape);
  std::vector<double> light, masses(parts.count());
  for (std::size_t j = 0; j < parts.bins(); ++j) {
    parts.at(j, light);
    const double weight = luminance_weight(channels, j);
    for (std::size_t f = 0; f < light.size(); ++f) masses[f] += weight * light[f];
  }
  const double mass = sum_of(masses);
  const auto lit = static_cast<std::size_t>(
      std::ranges::count_if(masses, [](double of_film) { return of_film > 0; }));
  const Jackknife jackknife(parts.count(), weights);
  FilmEstimate film{.shape = std::move(shape)};
  make_room(film);
  FilmDegrees degrees(parts.count());
  std::vector<double> values(parts.count());  // b times the share of the bin without each film
  for (std::size_t j = 0; j < parts.bins(); ++j) {
    parts.at(j, light);
    const double total = sum_of(light), share = total / mass;
    for (std::size_t f = 0; f < light.size(); ++f) {
      const double rest = mass - masses[f];
      values[f] =
          rest > 1e-12 * mass ? without[f] * std::max(0.0, total - light[f]) / rest : not_known;
    }
    const double value = b * pixels * share, error = pixels * jackknife.error(values);
    const double weight_of_bin = degrees.add(value, error * error);
    for (std::size_t f = 0; f < values.size(); ++f)
      degrees.move_bin(f, pixels * values[f] - value, weight_of_bin);
    film.value.push_back(value);
    film.standard_error.push_back(error);
  }
  degrees.tell(film);
  film.reliable = reliability_of_groups(film, lit);
  film.by_length = by_length(runs, b * pixels * static_cast<double>(parts.count()) / mass);
  return film;
}

}  // namespace wander
