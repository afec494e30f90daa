// Runs whose truth is known: films of a flat scene with errors of a chosen law.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "lab/compare/comparison.h"
#include "tests/support/generator.h"

namespace wander::test {

inline FilmEstimate made_film(std::vector<double> value, double error) {
  FilmEstimate film;
  film.shape = {static_cast<int>(value.size())};
  film.standard_error = std::vector<double>(value.size(), error);
  film.reliable = std::vector<bool>(value.size(), true);
  film.degrees_of_freedom = 31;
  film.value = std::move(value);
  return film;
}

// Student's t of an odd number of degrees, of variance 1.
inline double heavy_tailed(Generator& random, int degrees) {
  const double z = random.normal();
  double chi2 = 0;
  for (int i = 0; i < degrees; ++i) {
    const double x = random.normal();
    chi2 += x * x;
  }
  return z / std::sqrt(chi2 / (degrees - 2));
}

// The errors of the bins of one run, of mean square 1 in expectation.
struct ErrorLaw {
  const char* name;
  std::function<std::vector<double>(Generator&, std::size_t)> draw;
};

inline std::vector<double> independent_errors(Generator& random, std::size_t bins) {
  std::vector<double> errors(bins);
  for (double& error : errors) error = random.normal();
  return errors;
}
inline std::vector<double> common_errors(Generator& random, std::size_t bins) {
  return std::vector<double>(bins, random.normal());
}
inline std::vector<double> half_common_errors(Generator& random, std::size_t bins) {
  const double common = random.normal();
  std::vector<double> errors = independent_errors(random, bins);
  for (double& error : errors) error = std::sqrt(0.5) * (error + common);
  return errors;
}
inline std::vector<double> heavy_errors(Generator& random, std::size_t bins) {
  std::vector<double> errors(bins);
  for (double& error : errors) error = heavy_tailed(random, 5);
  return errors;
}
inline std::vector<double> uneven_errors(Generator& random, std::size_t bins) {
  const double scale = std::exp(random.normal() / 2 - 0.25);
  std::vector<double> errors = independent_errors(random, bins);
  for (double& error : errors) error *= scale;
  return errors;
}

inline const std::vector<ErrorLaw>& error_laws() {
  static const std::vector<ErrorLaw> laws{{"independent", independent_errors},
                                          {"common", common_errors},
                                          {"half common", half_common_errors},
                                          {"heavy tails", heavy_errors},
                                          {"uneven runs", uneven_errors}};
  return laws;
}

// One method: the relative RMSE of its runs is `error_at_one_second` / √seconds.
struct MadeMethod {
  std::string label;
  double error_at_one_second = 0.1;
  double bias = 0;  // of every bin
  std::function<std::vector<double>(Generator&, std::size_t)> errors = independent_errors;
};

struct MadeScene {
  std::size_t bins = 16, replicates = 8;
  std::vector<double> seconds{1, 2, 4, 8};
  double reference_error = 0;  // standard error of every bin of the reference
  std::function<std::vector<double>(Generator&, std::size_t)> reference_errors = independent_errors;
};

inline compare::Runs made_runs(const MadeScene& scene, const std::vector<MadeMethod>& methods,
                               Generator& random) {
  compare::Runs runs;
  runs.replicates = scene.replicates;
  for (const MadeMethod& method : methods) runs.contenders.push_back({method.label, "mlt", "", ""});
  for (const double seconds : scene.seconds)
    runs.budgets.push_back(std::to_string(static_cast<int>(seconds)) + "s");
  std::vector<double> truth = scene.reference_errors(random, scene.bins);
  for (double& value : truth) value = 1 + scene.reference_error * value;
  runs.reference.film = made_film(truth, scene.reference_error);
  runs.reference.film.degrees_of_freedom = 0;
  runs.reference.origin = "made for a test";
  for (std::size_t r = 0; r < scene.replicates; ++r)
    for (std::size_t b = 0; b < scene.seconds.size(); ++b)
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const double error = methods[m].error_at_one_second / std::sqrt(scene.seconds[b]);
        std::vector<double> value = methods[m].errors(random, scene.bins);
        for (double& x : value) x = 1 + methods[m].bias + error * x;
        compare::Run run{m, b, r, r + 1, 1000, scene.seconds[b], 0.1, 10, {}};
        run.processor_seconds = run.seconds;
        run.film = made_film(std::move(value), error);
        runs.runs.push_back(run);
      }
  return runs;
}

}  // namespace wander::test
