#include "lab/compare/trial.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/film_statistics.h"
#include "lab/compare/schedule.h"
#include "lab/film_pool.h"
#include "lab/method.h"
#include "mlt/seeds/nothing_found.h"
#include "statistics/squared.h"

namespace wander::compare {

namespace {

constexpr std::size_t runs_of_each = 4;
constexpr double share = 0.03;                    // of the runs and a reference together
constexpr double shortest = 0.02, longest = 0.5;  // seconds of a run
constexpr double fewest = 2'000, most = 200'000;  // samples of a run
constexpr double evidence = 4;                    // squared standard errors

// The reference of all checks first.
std::vector<const Method*> methods_of_trial() {
  auto methods = methods_that([](const Method& method) { return method.makes_references; });
  std::stable_partition(methods.begin(), methods.end(),
                        [](const Method* method) { return method->check == CheckRole::reference; });
  return methods;
}

double largest_value(const std::vector<FilmEstimate>& films) {
  double unit = 0;  // squares stay finite
  for (const FilmEstimate& film : films)
    for (const double x : film.value) unit = std::max(unit, x);
  return unit > 0 ? unit : 1;
}

double own_variance(const FilmEstimate& film, double unit) {
  double sum = 0;
  for (const double error : film.standard_error) sum += squared(error / unit);
  return sum;
}

// What `other` has found and `film` has not.
double unseen(const FilmEstimate& film, const FilmEstimate& other, double unit) {
  double sum = 0;
  for (std::size_t b = 0; b < film.value.size(); ++b) {
    if (!(other.value[b] > film.value[b])) continue;
    sum += squared((other.value[b] - film.value[b]) / unit) -
           squared(film.standard_error[b] / unit) -
           evidence * squared(other.standard_error[b] / unit);
  }
  return std::max(sum, 0.0);
}

Worth worth_of(const Candidate& candidate, double variance) {
  double samples = 0, seconds = 0;
  for (const Rendering& run : candidate.runs) {
    samples += static_cast<double>(run.samples);
    seconds += run.seconds;
  }
  return {candidate.method, variance > 0 ? 1 / (variance * samples) : 0, seconds / samples};
}

struct Limits {
  double least, most;
};
Limits limits_of_a_run(const Plan& plan) {
  const bool is_time = std::holds_alternative<TimeBudget>(plan.budgets.back().budget);
  return is_time ? Limits{shortest, longest} : Limits{fewest, most};
}

double effort_of_a_run(const Plan& plan) {
  const double all = effort_of(plan) + reference_effort(plan);
  return share * all / static_cast<double>(methods_of_trial().size() * runs_of_each);
}

Budget budget_of_a_run(const Plan& plan) {
  const auto [least, most_of_all] = limits_of_a_run(plan);
  return budget_of(std::clamp(effort_of_a_run(plan), least, most_of_all),
                   plan.budgets.back().budget);
}

// In so small a comparison all that chains need before they begin would be most of it.
bool takes_part(const Method& method, const Plan& plan) {
  return !method.is_markov_chain() || effort_of_a_run(plan) >= limits_of_a_run(plan).least;
}

}  // namespace

std::vector<Worth> ranked(const std::vector<Candidate>& candidates) {
  std::vector<FilmEstimate> films;
  for (const Candidate& candidate : candidates) films.push_back(pooled_film(candidate.runs));
  const double unit = largest_value(films);
  std::vector<Worth> worths;
  for (std::size_t m = 0; m < films.size(); ++m) {
    double missed = 0;
    for (const FilmEstimate& other : films)
      missed = std::max(missed, unseen(films[m], other, unit));
    const double variance = is_dark(films[m]) ? 0 : own_variance(films[m], unit) + missed;
    worths.push_back(worth_of(candidates[m], variance));
  }
  std::ranges::stable_sort(worths, std::ranges::greater{}, &Worth::efficiency);
  return worths;
}

std::vector<Worth> hold_trial(const Plan& plan, Course& course) {
  const std::vector<const Method*> methods = methods_of_trial();
  std::vector<Candidate> candidates;
  for (const Method* method : methods)
    if (takes_part(*method, plan) && method->sees_all_light(course.scene()))
      candidates.push_back({std::string(method->name)});
  const Budget budget = budget_of_a_run(plan);
  for (std::size_t r = 0; r < runs_of_each; ++r)
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      if (course.is_interrupted()) return {};
      try {
        const std::uint64_t seed = trial_seed(plan.seed, r * methods.size() + c);
        Rendering run = course.render(course.usual(find_method(candidates[c].method)), budget, seed,
                                      "trial: " + candidates[c].method);
        if (run.samples > 0) candidates[c].runs.push_back(std::move(run));
      } catch (const NoLightFound&) {
        continue;
      }
    }
  if (course.is_interrupted()) return {};
  std::erase_if(candidates, [](const Candidate& c) { return c.runs.size() < runs_of_each; });
  return ranked(candidates);
}

double trial_effort(const Plan& plan) {
  const auto runs =
      runs_of_each * std::ranges::count_if(methods_of_trial(), [&](const Method* method) {
        return takes_part(*method, plan);
      });
  return static_cast<double>(runs) * effort_of(budget_of_a_run(plan));
}

}  // namespace wander::compare
