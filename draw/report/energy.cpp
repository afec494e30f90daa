#include "draw/report/energy.h"

#include <cmath>
#include <set>

#include "core/film_statistics.h"

namespace wander::report {
namespace {

// A length that a run has not met contributed nothing to it.
double mean_light(const FilmEstimate& film, int vertices) {
  const auto found = film.by_length.find(vertices);
  if (found == film.by_length.end() || found->second.empty()) return 0;
  return mean_value({.shape = film.shape, .value = found->second});
}

compare::Measured mean_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / count;
  if (values.size() < 2) return {mean, {}};
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double half_width =
      student_t_95(count - 1) * std::sqrt(squares / (count - 1)) / std::sqrt(count);
  return {mean, {mean - half_width, mean + half_width}};
}

}  // namespace

std::map<int, compare::Measured> energy_by_length(const std::vector<const Run*>& replicates) {
  std::set<int> lengths;
  for (const Run* run : replicates)
    for (const auto& [vertices, film] : run->film.by_length) lengths.insert(vertices);
  std::map<int, compare::Measured> energy;
  for (const int vertices : lengths) {
    std::vector<double> values;
    for (const Run* run : replicates) values.push_back(mean_light(run->film, vertices));
    energy[vertices] = mean_of(values);
  }
  return energy;
}

}  // namespace wander::report
