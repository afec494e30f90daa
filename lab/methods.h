// The methods of `render` by name: the one place where a name becomes an algorithm.
#pragma once

#include <span>
#include <string_view>

#include "core/description.h"
#include "lab/dials.h"
#include "lab/drive.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

// pt, lt, bdpt, mlt, pssmlt, mmlt, pt-naive, lt-naive.
std::span<const std::string_view> method_names();

// Throws UsageError, with the reason, where the method cannot render such a scene at all.
void require_possible(std::string_view method, const description::Scene& scene);

// Light tracing reaches a camera by connections alone, which mirrors and smooth glass forbid.
bool sees_all_light(std::string_view method, const description::Scene& scene);

// `method` is one of method_names(); dials that it does not have are of no effect.  Throws
// UsageError if the scene does not fit into the precision, and std::runtime_error.
Rendering render(const description::Scene& scene, std::string_view method, const Dials& dials,
                 const Session& session);

// The same, from where a run was kept, which was of the same scene, method, dials and seed.  What it
// has taken of the budget counts.  Throws CommandFailure where its state cannot be read.
Rendering carry_on(const KeptRun& from, const description::Scene& scene, std::string_view method,
                   const Dials& dials, const Session& session, const Keeper& keeper);

}  // namespace wander
