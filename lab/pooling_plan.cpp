#include "lab/pooling_plan.h"

#include <algorithm>
#include <variant>

#include "lab/pilot_run.h"

namespace wander {

std::optional<PoolingPlan> PoolingPlanner::by_samples(Pilot samples) const {
  if (settings_.seed_share || film_.kind == FilmKind::image) return {};
  samples.seeds_per_step = seeds_per_step();
  const auto pooling = pooling_of_easy_light(samples, film_.bins, most_cost());
  return pooling ? std::optional(plan(samples, *pooling)) : std::nullopt;
}

PoolingPlan PoolingPlanner::by_chains(Pilot pilot) const {
  pilot.seeds_per_step = seeds_per_step();
  if (settings_.seed_share && !is_of_error())
    return plan(pilot, with_seed_share(pilot, *settings_.seed_share));
  if (!is_telling(pilot) && has_all_samples_before())
    return plan(pilot, with_seed_share(pilot, seed_share_in_the_dark(pilot)));
  if (has_all_samples_before())
    pilot.steps_per_seed.reset();
  else if (is_telling(pilot))
    pilot.steps_per_seed =
        steps() / static_cast<double>(std::max(settings_.fewest_seeds, seeds_for(pilot)));
  // Nobody knows how many steps an error takes: so many samples for each of them go on beside the chains.
  return plan(pilot, settings_.seed_share ? pooling(pilot, *settings_.seed_share, film_.bins)
                                          : cautious_pooling(pilot, film_.bins, most_cost()));
}

bool PoolingPlanner::leaves_to_samples(const Pilot& pilot) const {
  return film_.kind == FilmKind::image && !settings_.seed_share && is_telling(pilot) &&
         is_left_to_samples(by_chains(pilot).pooling, pilot.b());
}

double PoolingPlanner::steps_per_chain() const {
  const ChainSettings settings = settings_of_chains({}, 0);
  const auto expected = static_cast<std::uint64_t>(expected_steps(run_).value_or(0));
  return steps() / (settings.groups * settings.chains_for(expected));
}

// Of an error it is not known.
double PoolingPlanner::steps() const {
  const auto usual = static_cast<double>(ChainSettings{}.steps_per_chain);
  return expected_steps(run_).value_or(usual * settings_.groups * settings_.chains_per_group);
}

double PoolingPlanner::seeds_per_step() const {
  return is_of_time() ? 0 : static_cast<double>(settings_.fewest_seeds) / steps();
}

double PoolingPlanner::most_cost() const {
  const bool is_of_steps = std::holds_alternative<SampleBudget>(run_.session().budget);
  return is_of_steps ? most_cost_of_given_steps : usual_most_cost;
}

bool PoolingPlanner::is_of_time() const {
  return std::holds_alternative<TimeBudget>(run_.session().budget);
}

bool PoolingPlanner::is_of_error() const {
  return std::holds_alternative<ErrorBudget>(run_.session().budget);
}

// Of an image, if the budget says how many they are.
bool PoolingPlanner::has_all_samples_before() const {
  return film_.kind == FilmKind::image && !is_of_error();
}

ChainSettings PoolingPlanner::settings_of_chains(const Pilot& pilot,
                                                 double samples_per_step) const {
  ChainSettings settings = settings_;
  if (settings_.has_given_chains()) return settings;
  if (film_.kind == FilmKind::image) {
    using Many = ChainsOfImage;
    settings.chains_per_group = chains_in_memory(Many::chains_per_group, film_.max_vertices);
    settings.steps_per_chain =
        samples_per_step < 1 ? Many::steps_per_chain : Many::steps_per_chain_of_rare_light;
  } else if (finds_rare_light(pilot)) {
    settings.chains_per_group = RareLight::chains_per_group;
    settings.steps_per_chain = RareLight::steps_per_chain;
  }
  return settings;
}

double PoolingPlanner::seed_share_in_the_dark(const Pilot& pilot) const {
  if (!finds_rare_light(pilot)) return ChainSettings::usual_seed_share;
  return is_of_time() ? RareLight::seed_share_of_time : RareLight::samples_per_step;
}

double PoolingPlanner::seed_share(const Pilot& pilot, const Pooling& pooling) const {
  if (settings_.seed_share) return *settings_.seed_share;
  if (!is_telling(pilot)) return seed_share_in_the_dark(pilot);
  if (!has_all_samples_before()) return 0;
  return pooling.samples_per_step * (is_of_time() ? pooling.cost_of_sample : 1);
}

PoolingPlan PoolingPlanner::plan(const Pilot& pilot, const Pooling& pooling) const {
  PoolingPlan made{pooling, settings_of_chains(pilot, pooling.samples_per_step),
                   seed_share(pilot, pooling)};
  // Where samples go on beside the chains, seeds need no more than the fewest, or what it takes for
  // the slice of a group to find light.
  if ((!settings_.seed_share || is_of_error()) && is_telling(pilot))
    made.settings.fewest_seeds = std::max(settings_.fewest_seeds, seeds_for(pilot));
  return made;
}

// All samples before the chains: of a budget of time the share is one of seconds.
Pooling PoolingPlanner::with_seed_share(Pilot pilot, double share) const {
  const double cost = pooling(pilot, share, film_.bins).cost_of_sample;
  const double samples_per_step = is_of_time() && cost > 0 ? share / cost : share;
  pilot.steps_per_seed.reset();
  Pooling all_before = pooling(pilot, samples_per_step, film_.bins);
  all_before.samples_per_step = 0;
  return all_before;
}

// So that the slice of a group carries so many effective samples; no more than the usual share.
std::uint64_t PoolingPlanner::seeds_for(const Pilot& pilot) const {
  constexpr double effective_samples_of_slice = 16;
  double seeds =
      effective_samples_of_slice * settings_.groups * pilot.samples / pilot.effective_samples();
  if (const auto* budget = std::get_if<SampleBudget>(&run_.session().budget))
    seeds = std::min(seeds, ChainSettings::usual_seed_share * static_cast<double>(budget->samples));
  return static_cast<std::uint64_t>(std::min(seeds, 1e9));
}

}  // namespace wander
