// What errors are measured against, and how well it is known.
//
//   a file   a film that was made before
//   exact    where the scene is diffuse: core/exact/diffuse_film.h
//   long     else two independent runs of the best contender, each of 3/2 × the largest budget ×
//   the
//            replicates: together they have 3R times the samples of a run at that budget, so that
//            the reference's variance is 1 / 3R of what is measured.  Their mean is the reference.
//
// Best is, of the methods at the base point that can find all light, the one with the least
// relative spread over the replicates at the largest budget.  Long runs that are known from before
// do where their error is at most 1.5 times what two fresh ones would have; else two more are made
// and pooled with them.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/description.h"
#include "tools/compare/course.h"
#include "tools/compare/measure.h"
#include "tools/compare/reference_cache.h"
#include "tools/compare/runs.h"

namespace wander::compare {

// Throws UsageError where no film of this shape is in it, RunFileError where it cannot be read.
Reference reference_from_file(const std::filesystem::path& file, const std::vector<int>& shape,
                              const Provenance& scene, std::vector<std::string>& warnings);

// None where the scene is not diffuse, or not known exactly enough; `why` then says so.
std::optional<Reference> exact_reference(const description::Scene& scene, std::string& why);

// Of both long runs together (effort_of).
double long_effort(const Plan& plan);

// After an interruption, what is known is all there is: perhaps a film of unknown values.
// Throws CommandFailure if no contender found light.
Reference long_reference(const description::Scene& scene, const Plan& plan,
                         const ReferenceCache& cache, Course& course, Runs& runs);

}  // namespace wander::compare
