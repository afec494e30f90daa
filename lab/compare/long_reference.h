// The reference where none is exact and none was given: long runs of the two methods that do best
// in a short trial (trial.h), pooled (reference_pool.h), before anything is measured.
//
// Each method makes two runs, by turns, of 3/4 × the replicates R × the longest measured run in
// time: together they take as long as 3R of those, so that the error of the reference is small
// against what is measured even where the best contender made it.  With budgets of samples the
// runs get as many samples as that time holds by the trial.
//
// Long runs are kept (reference_cache.h).  Those of two methods do if they are worth at least
// 1 / 1.5² of what fresh ones would be, by the trial, each method's and both together; else fresh
// ones are added to them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/description.h"
#include "lab/compare/course.h"
#include "lab/compare/make_runs.h"
#include "lab/compare/reference_cache.h"
#include "lab/compare/trial.h"

namespace wander::compare {

struct Maker {
  Worth worth;
  LongRuns runs;  // that are known
  Budget budget;  // of each run that is to come
};

struct LongPlan {
  std::vector<Maker> makers;                 // one or two
  std::vector<std::uint64_t> taken_seeds{};  // by known runs, of whomever
  std::size_t more = 0;                      // runs that are to come, of each
  double seconds = 0;                        // that these will take
};

// `longest` is what the slowest contender takes for the largest budget, in seconds.
LongPlan plan_reference(const Plan& plan, const std::vector<Worth>& worths,
                        const std::vector<LongRuns>& known, double longest);

double effort_of(const LongPlan& plan);

// After an interruption, of the runs that there are; none if there are none.  What is made is kept.
// Throws CommandFailure if no light was found.
Reference make_reference(const Plan& plan, LongPlan reference, const ReferenceCache& cache,
                         Course& course, const std::vector<int>& shape, Runs& runs);

}  // namespace wander::compare
