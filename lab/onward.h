// What a run that is kept does when another budget is given.
#pragma once

#include <functional>

#include "lab/drive.h"
#include "lab/job.h"
#include "work/session.h"

namespace wander {

enum class Onward {
  further,      // goes on from where it is, and the budget is its own from then on
  as_planned,   // the same within its own budget, which it keeps
  begun_again,  // begins again, from nothing
  enough        // stays as it is: it has what is asked for
};

// A pooled run of so few steps that the plan for them counts on the samples of its seed pass (Pilot::seeds_per_step)
// leaves nearly all light to samples, of which many steps would have few.  Beyond what was planned it begins again, which
// costs little.  `error` tells the relative error of its film, NaN if that is not known; it is asked for an error budget
// alone.
Onward onward(const Budget& planned, const Budget& next, const Headway& done,
              const std::function<double()>& error, const Job& job);

}  // namespace wander
