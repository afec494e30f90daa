#include "lab/compare/make_runs.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "lab/compare/film_loan.h"
#include "lab/compare/schedule.h"
#include "lab/failure.h"
#include "lab/shell_words.h"
#include "mlt/seeds/nothing_found.h"

namespace wander::compare {

namespace {

std::string command_of(const Plan& plan, const Turn& turn) {
  const Entrant& entrant = plan.entrants[turn.contender];
  std::vector<std::string> words{"wander",
                                 "render",
                                 plan.source,
                                 "-m",
                                 entrant.contender.method,
                                 "-b",
                                 plan.budgets[turn.budget].text};
  for (const Setting& setting : entrant.settings) {
    words.push_back(setting.dial->option());
    words.push_back(setting.value);
  }
  words.insert(words.end(), {"-s", std::to_string(turn.seed)});
  if (plan.threads > 0) words.insert(words.end(), {"-t", std::to_string(plan.threads)});
  words.insert(words.end(), {"-o", "run"});
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return quoted_for_shell(static_cast<int>(pointers.size()), pointers.data());
}

Run run_of(const Plan& plan, const Turn& turn, const Rendering& rendering) {
  return {.contender = turn.contender,
          .budget = turn.budget,
          .replicate = turn.replicate,
          .seed = turn.seed,
          .samples = rendering.samples,
          .seconds = rendering.seconds,
          .seed_seconds = rendering.seed_seconds,
          .seed_samples = seed_samples_of(rendering),
          .film = rendering.film,
          .command = command_of(plan, turn),
          .processor_seconds = rendering.processor_seconds};
}

std::string name_of(const Plan& plan, const Turn& turn) {
  return fmt::format("{} {}, replicate {} of {}", plan.entrants[turn.contender].contender.label,
                     plan.budgets[turn.budget].text, turn.replicate + 1, plan.replicates);
}

// None if it was interrupted.
std::optional<FinishedTurn> made(const Plan& plan, const Turn& turn, Course& course) {
  try {
    Rendering rendering =
        course.render(plan.entrants[turn.contender].job.value(), plan.budgets[turn.budget].budget,
                      turn.seed, name_of(plan, turn));
    if (!rendering.complete) return std::nullopt;
    return finished(plan, turn, std::move(rendering));
  } catch (const NoLightFound& dark) {
    return FinishedTurn{
        .failure = FailedRun{turn.contender, turn.budget, turn.replicate, turn.seed, dark.what()}};
  }
}

void add(FinishedTurn finished, Runs& runs) {
  if (finished.details) runs.details[finished.run->contender] = *std::move(finished.details);
  if (finished.run) runs.runs.push_back(*std::move(finished.run));
  if (finished.failure) runs.failures.push_back(*std::move(finished.failure));
}

}  // namespace

std::vector<Turn> turns_of(const Plan& plan) {
  return schedule({plan.entrants.size(), plan.budgets.size(), plan.replicates}, plan.seed);
}

FinishedTurn finished(const Plan& plan, const Turn& turn, Rendering rendering) {
  FinishedTurn finished{.run = run_of(plan, turn, rendering)};
  if (turn.replicate == 0 && turn.budget + 1 == plan.budgets.size())
    finished.details = std::move(rendering);
  return finished;
}

double reference_effort(const Plan& plan) {
  return 3 * static_cast<double>(plan.replicates) * effort_of(plan.budgets.back().budget);
}

std::uint64_t seed_samples_of(const Rendering& rendering) {
  if (!rendering.normalization) return 0;
  const auto& estimates = rendering.normalization->estimates;
  const auto found = estimates.find("seed_pass");
  return found == estimates.end() ? 0 : found->second.samples;
}

void require_few_enough(const Plan& plan) {
  const std::size_t runs = plan.entrants.size() * plan.budgets.size() * plan.replicates;
  if (runs > most_runs)
    throw UsageError(fmt::format("{} runs: a comparison makes at most {}", runs, most_runs));
}

double effort_of(const Plan& plan) {
  double of_one = 0;
  for (const NamedBudget& budget : plan.budgets) of_one += effort_of(budget.budget);
  return of_one * static_cast<double>(plan.entrants.size() * plan.replicates);
}

double effort_of(const Plan& plan, const std::vector<Turn>& turns) {
  double effort = 0;
  for (const Turn& turn : turns) effort += effort_of(plan.budgets[turn.budget].budget);
  return effort;
}

Runs prepared(const Plan& plan, Provenance provenance) {
  Runs runs{.provenance = std::move(provenance), .replicates = plan.replicates};
  for (const Entrant& entrant : plan.entrants) runs.contenders.push_back(entrant.contender);
  for (const NamedBudget& budget : plan.budgets) runs.budgets.push_back(budget.text);
  runs.details.resize(plan.entrants.size());
  runs.time = time_kind_of(plan.budgets.back().budget);
  return runs;
}

std::vector<Turn> turns_to_come(const Plan& plan, const KeptComparison& kept) {
  std::vector<Turn> turns = turns_of(plan);
  std::erase_if(turns, [&](const Turn& turn) { return kept.has(turn); });
  return turns;
}

void make_runs(const Plan& plan, Course& course, KeptComparison& kept, Runs& runs) {
  runs.shelf = [&kept](const Run& run) { return kept.film_of(run); };
  for (const Turn& turn : turns_of(plan)) {
    if (kept.has(turn)) {
      add(kept.take(turn), runs);
      continue;
    }
    runs.complete = !course.is_interrupted();
    if (!runs.complete) break;
    std::optional<FinishedTurn> finished = made(plan, turn, course);
    runs.complete = finished.has_value();
    if (!runs.complete) break;
    kept.keep(*finished);
    if (finished->run && kept.has_film_of(*finished->run)) shelve(finished->run->film);
    add(*std::move(finished), runs);
  }
  kept.keep_all();
}

}  // namespace wander::compare
