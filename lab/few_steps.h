// Runs of few steps, which are not carried on to many.
#pragma once

#include <functional>

#include "lab/drive.h"
#include "lab/job.h"
#include "work/session.h"

namespace wander {

// So few that the plan for them counts on the samples of the seed pass (Pilot::seeds_per_step), which leaves nearly all
// light to samples, of which many steps would have few.  To a budget that asks for more such a run begins again, which
// costs little; where that asks for no more the run stays as it is, and so does its plan.
bool is_of_few_steps(const Budget& planned, const Job& job);

// Than is done.  `error` tells the relative error of the film, NaN if that is not known; it is asked for an error budget
// alone.
bool asks_for_more(const Budget& budget, const Headway& done, const std::function<double()>& error);

}  // namespace wander
