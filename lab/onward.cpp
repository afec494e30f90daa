#include "lab/onward.h"

#include <variant>

#include "mlt/run/partition.h"

namespace wander {

namespace {

bool is_of_few_steps(const Budget& planned, const Job& job) {
  const auto* count = std::get_if<SampleBudget>(&planned);
  const ChainSettings& chains = job.dials().chains;
  return count && job.method().is_markov_chain() && chains.film_parts == FilmParts::pooled &&
         static_cast<double>(chains.fewest_seeds) >
             fewest_samples_per_step * static_cast<double>(count->samples);
}

bool is_met(const Budget& budget, const Headway& done, const std::function<double()>& error) {
  if (const auto* count = std::get_if<SampleBudget>(&budget)) return count->samples <= done.samples;
  if (const auto* time = std::get_if<TimeBudget>(&budget))
    return time->seconds <=
           (time->kind == TimeKind::wall ? done.wall_seconds : done.processor_seconds);
  return error() <= std::get<ErrorBudget>(budget).relative;
}

}  // namespace

Onward onward(const Budget& planned, const Budget& next, const Headway& done,
              const std::function<double()>& error, const Job& job) {
  if (!is_of_few_steps(planned, job)) return Onward::further;
  const auto* count = std::get_if<SampleBudget>(&next);
  if (count && count->samples <= std::get<SampleBudget>(planned).samples) return Onward::as_planned;
  // A seed pass that was stopped has nothing to show yet.
  return done.samples > 0 && is_met(next, done, error) ? Onward::enough : Onward::begun_again;
}

}  // namespace wander
