// Where a method makes its run: a job, and its scene in one world.
#pragma once

#include <memory>

#include "core/transport.h"
#include "lab/job.h"
#include "lab/live_run.h"
#include "work/parallel.h"

namespace wander {

// All of it is there as long as the run that is made.
template <World W>
struct Stage {
  const Job& job;
  const Run& execution;
  const Scene<W>& scene;
  const Transport<W>& space;  // without roulette
};

}  // namespace wander
