// The check of a scene: does each mutation leave the target invariant on it, and do the methods agree?
#pragma once

#include "lab/job.h"
#include "scenes/format/scene_file.h"
#include "tools/check_report.h"
#include "work/session.h"

namespace wander {

// Of independent paths from which each mutation starts.
inline constexpr std::uint64_t usual_check_samples = 200'000;

// Whose mutations are checked.
const Method& mutated_method();

// The job is of the mutated_method() and the scene.  Throws CommandFailure if it is interrupted.
CheckReport check(const SceneDocument& document, const Job& job, std::uint64_t samples,
                  const Session& session);

}  // namespace wander
