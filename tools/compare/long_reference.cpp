// The reference where none is exact.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/output/film_pool.h"
#include "core/output/film_statistics.h"
#include "mlt/render.h"
#include "tools/compare/reference.h"
#include "tools/compare/schedule.h"
#include "tools/failure.h"
#include "tools/methods.h"
#include "tools/wording.h"

namespace wander::compare {

namespace {

constexpr double runs_of_each = 1.5;    // × replicates × the largest budget
constexpr double largest_excess = 1.5;  // over what fresh runs would have
constexpr double unknown = not_known;

// √(Σ var / Σ mean²) over the bins: of one run of this contender at the largest budget.
double relative_spread(const Runs& runs, std::size_t contender) {
  std::vector<const FilmEstimate*> films;
  for (const Run& run : runs.runs)
    if (run.contender == contender && run.budget + 1 == runs.budgets.size())
      films.push_back(&run.film);
  if (films.size() < 2) return unknown;
  const auto count = static_cast<double>(films.size());
  double unit = 0;  // squares stay finite
  for (const FilmEstimate* film : films)
    unit = std::max(unit, *std::ranges::max_element(film->value));
  double variance = 0, size = 0;
  for (std::size_t b = 0; b < films.front()->value.size(); ++b) {
    double mean = 0, squares = 0;
    for (const FilmEstimate* film : films) mean += film->value[b] / unit / count;
    for (const FilmEstimate* film : films) squares += std::pow(film->value[b] / unit - mean, 2);
    variance += squares / (count - 1);
    size += mean * mean;
  }
  return std::sqrt(variance / size);  // not a number where no light was found
}

struct Best {
  const Entrant* entrant = nullptr;
  double spread = std::numeric_limits<double>::infinity();
};

Best best_of(const description::Scene& scene, const Plan& plan, const Runs& runs) {
  Best best;
  for (std::size_t c = 0; c < plan.entrants.size(); ++c) {
    const Entrant& entrant = plan.entrants[c];
    if (!entrant.contender.dial.empty() || !sees_all_light(entrant.contender.method, scene))
      continue;
    const double spread = relative_spread(runs, c);
    if (spread < best.spread) best = {&entrant, spread};
  }
  return best;
}

std::string made_by(const Entrant& entrant) {
  std::string text = entrant.contender.method;
  for (const Setting& setting : entrant.settings)
    text += fmt::format(" {} {}", setting.dial->option(), setting.value);
  return text;
}

Reference pooled(const LongRuns& runs) {
  double seconds = 0, samples = 0;
  for (const Rendering& run : runs.runs) {
    seconds += run.seconds;
    samples += static_cast<double>(run.samples);
  }
  return {pooled_film(runs.runs),
          fmt::format("the mean of {} independent runs of {}, {} samples together, {}",
                      runs.runs.size(), runs.made_by, count_in_words(samples),
                      duration_in_words(seconds))};
}

Reference none(const FilmEstimate& like) {
  FilmEstimate film{.shape = like.shape};
  film.value.assign(like.value.size(), unknown);
  film.standard_error.assign(like.value.size(), unknown);
  film.reliable.assign(like.value.size(), false);
  return {std::move(film), "none: no long run was made to its end"};
}

// Those of films like the measured ones; least error first.
std::vector<LongRuns> known_runs(const ReferenceCache& cache, Runs& runs) {
  std::vector<LongRuns> known = cache.load(runs.warnings);
  std::erase_if(known, [&](const LongRuns& k) {
    return k.runs.front().film.shape != runs.runs.front().film.shape;
  });
  std::ranges::sort(known, {},
                    [](const LongRuns& k) { return relative_error(pooled_film(k.runs)); });
  return known;
}

// Two more; fewer if interrupted.  What an interrupted run found is a film, too.
void extend(LongRuns& runs, const Plan& plan, const Entrant& entrant, std::uint64_t first,
            Course& course, std::vector<std::string>& warnings) {
  const Budget budget = budget_of(0.5 * long_effort(plan), plan.budgets.back().budget);
  const std::string what = fmt::format("reference: {} {}", runs.made_by, text_of(budget));
  for (std::uint64_t i = 0; i < 2 && !course.is_interrupted(); ++i) {
    try {
      Rendering run = course.render(entrant, budget, reference_seed(plan.seed, first + i), what);
      if (run.samples > 0) runs.runs.push_back(std::move(run));
    } catch (const NoLightFound& dark) {
      warnings.push_back(fmt::format("{} failed: {}", what, dark.what()));
    }
  }
}

// Of two fresh long runs together, in units of the spread of one run at the largest budget.
double expected_error(const Plan& plan) {
  return 1 / std::sqrt(2 * runs_of_each * static_cast<double>(plan.replicates));
}

[[noreturn]] void give_up() {
  throw CommandFailure(
      ExitCode::failure,
      "nothing to measure errors against: at the largest budget, no contender that can find all "
      "light found any twice; give a larger -b, another method (-m bdpt,mlt), or --reference FILE");
}

}  // namespace

double long_effort(const Plan& plan) {
  return 2 * runs_of_each * static_cast<double>(plan.replicates) *
         effort_of(plan.budgets.back().budget);
}

Reference long_reference(const description::Scene& scene, const Plan& plan,
                         const ReferenceCache& cache, Course& course, Runs& runs) {
  std::vector<LongRuns> known = known_runs(cache, runs);
  const Best best = best_of(scene, plan, runs);
  const bool is_enough = !known.empty() && relative_error(pooled_film(known.front().runs)) <=
                                               largest_excess * expected_error(plan) * best.spread;
  if (!known.empty() && (is_enough || !runs.complete)) return pooled(known.front());
  const auto without = [&] { return none(runs.runs.front().film); };
  if (!runs.complete) return without();
  if (!best.entrant) give_up();

  std::uint64_t earlier = 0;
  LongRuns best_runs{made_by(*best.entrant), {}};
  for (LongRuns& k : known) {
    earlier += k.runs.size();
    if (k.made_by == best_runs.made_by) best_runs.runs = std::move(k.runs);
  }
  extend(best_runs, plan, *best.entrant, earlier, course, runs.warnings);
  runs.complete = !course.is_interrupted();
  if (runs.complete && !best_runs.runs.empty()) cache.store(best_runs, runs.warnings);
  return best_runs.runs.empty() ? without() : pooled(best_runs);
}

}  // namespace wander::compare
