// Makes the runs of a comparison.
#pragma once

#include <string>
#include <vector>

#include "lab/compare/budgets.h"
#include "lab/compare/course.h"
#include "lab/compare/kept_comparison.h"
#include "lab/compare/lineup.h"
#include "lab/compare/runs.h"

namespace wander::compare {

struct Plan {
  std::string source;             // SCENE, as typed
  std::vector<Entrant> entrants;  // with their jobs, where runs are made
  std::vector<NamedBudget> budgets;
  std::size_t replicates = 8;
  std::uint64_t seed = 1;
  int threads = 0;  // 0: all cores
};

// Throws UsageError where there would be more runs than seeds (most_runs).
void require_few_enough(const Plan& plan);

// The sum of all budgets (effort_of).
double effort_of(const Plan& plan);
// Of some turns.
double effort_of(const Plan& plan, const std::vector<Turn>& turns);

// All of them, in their order.
std::vector<Turn> turns_of(const Plan& plan);
// One that has come to its end, of its rendering.
FinishedTurn finished(const Plan& plan, const Turn& turn, Rendering rendering);
// Those that are not kept yet, in their order.
std::vector<Turn> turns_to_come(const Plan& plan, const KeptComparison& kept);

// Of the long runs that make a reference: 3 × replicates × the largest budget (long_reference.h).
double reference_effort(const Plan& plan);

// Of the seed pass; 0 for independent samples.
std::uint64_t seed_samples_of(const Rendering& rendering);

// What the plan says of the runs, before there are any.
Runs prepared(const Plan& plan, Provenance provenance);

// Turn after turn (schedule()), each kept when it has come to its end; what was kept before is taken
// from there, and outlives the runs: it is the shelf of their films.  An interruption drops the run
// that it hits and ends the rest.
void make_runs(const Plan& plan, Course& course, KeptComparison& kept, Runs& runs);

}  // namespace wander::compare
