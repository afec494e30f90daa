// Runs of few steps, which are not carried on to many.
#pragma once

#include "lab/job.h"
#include "work/session.h"

namespace wander {

// So few that the plan for them counts on the samples of the seed pass (Pilot::seeds_per_step), which leaves nearly all
// light to samples, of which many steps would have few.  To another budget such a run begins again, which costs little.
bool is_of_few_steps(const Budget& budget, const Job& job);

}  // namespace wander
