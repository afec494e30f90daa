// The job that a verb is asked for, with all that speaks against it rather than the first alone.
#pragma once

#include <optional>

#include "lab/job.h"
#include "tools/examination.h"

namespace wander {

// None where the examination found something.
std::optional<Job> examined_job(const description::Scene& scene, const Method& method,
                                const Dials& dials, Examination& examination);

}  // namespace wander
