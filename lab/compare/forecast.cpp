#include "lab/compare/forecast.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lab/compare/schedule.h"
#include "lab/wording.h"
#include "mlt/seeds/nothing_found.h"

namespace wander::compare {

namespace {

constexpr double samples_of_a_pace = 20'000;
constexpr std::uint64_t first_seed = 1'000;  // those of the trial are below

bool counts_seconds(const Plan& plan) {
  return std::holds_alternative<TimeBudget>(plan.budgets.back().budget);
}

Budget budget_of_a_pace(const Plan& plan) {
  const Budget& largest = plan.budgets.back().budget;
  return budget_of(std::min(samples_of_a_pace, effort_of(largest)), largest);
}

Pace pace_of(const Plan& plan, std::size_t contender, Course& course) {
  const Entrant& entrant = plan.entrants[contender];
  const ChainSettings& chains = entrant.dials.chains;
  try {
    const Rendering run = course.render(entrant.job.value(), budget_of_a_pace(plan),
                                        trial_seed(plan.seed, first_seed + contender),
                                        "timing " + entrant.contender.label);
    if (run.samples == 0) return {};
    const auto seeds = static_cast<double>(seed_samples_of(run));
    const double of_seeds = seeds > 0 ? run.seed_seconds : 0;
    const auto fewest = static_cast<double>(chains.fewest_seeds);
    const double share =
        seeds > fewest ? seeds / static_cast<double>(run.samples) : ChainSettings::usual_seed_share;
    return {.of_sample = (run.seconds - of_seeds) / static_cast<double>(run.samples),
            .of_seed = seeds > 0 ? of_seeds / seeds : 0,
            .seed_share = chains.seed_share.value_or(share),
            .fewest_seeds = fewest};
  } catch (const NoLightFound&) {
    return {};
  }
}

// What a contender takes for a budget.
double seconds_of(const Budget& budget, const Paces& paces, std::size_t contender) {
  if (const auto* time = std::get_if<TimeBudget>(&budget)) return time->seconds;
  return paces[contender].seconds(effort_of(budget));
}

}  // namespace

double Pace::seconds(double samples) const {
  return samples * of_sample + std::max(fewest_seeds, samples * seed_share) * of_seed;
}

Paces paces_of(const Plan& plan, Course& course) {
  Paces paces;
  if (counts_seconds(plan)) return paces;
  for (std::size_t c = 0; c < plan.entrants.size(); ++c)
    paces.push_back(course.is_interrupted() ? Pace{} : pace_of(plan, c, course));
  return paces;
}

double effort_of_paces(const Plan& plan) {
  if (counts_seconds(plan)) return 0;
  return static_cast<double>(plan.entrants.size()) * effort_of(budget_of_a_pace(plan));
}

Forecast forecast(const Plan& plan, const Paces& paces, const std::vector<Turn>& turns) {
  std::vector<std::string> budgets;
  for (const NamedBudget& budget : plan.budgets) budgets.push_back(budget.text);
  Forecast result{.runs = turns.size(), .budgets = fmt::format("{}", fmt::join(budgets, ", "))};
  for (std::size_t c = 0; c < plan.entrants.size(); ++c)
    for (const NamedBudget& budget : plan.budgets)
      result.longest = std::max(result.longest, seconds_of(budget.budget, paces, c));
  for (const Turn& turn : turns)
    result.of_runs += seconds_of(plan.budgets[turn.budget].budget, paces, turn.contender);
  return result;
}

std::string in_words(const Forecast& forecast) {
  std::string text = fmt::format("{} runs of {}", forecast.runs, forecast.budgets);
  if (forecast.of_reference > 0)
    text += fmt::format(", and a reference of about {}", duration_in_words(forecast.of_reference));
  return text + fmt::format(": about {}", duration_in_words(forecast.seconds()));
}

std::string json_line_of(const Forecast& forecast) {
  const nlohmann::ordered_json line{{"phase", "forecast"},
                                    {"fraction", 0.0},
                                    {"samples", 0},
                                    {"seconds", 0.0},
                                    {"samples_per_second", 0.0},
                                    {"runs", forecast.runs},
                                    {"expected_seconds", forecast.seconds()},
                                    {"expected_seconds_of_reference", forecast.of_reference}};
  return line.dump();
}

}  // namespace wander::compare
