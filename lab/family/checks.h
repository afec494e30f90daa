// The tests of invariance of `check` in one world.
#pragma once

#include <fmt/format.h>

#include "lab/failure.h"
#include "lab/family/family_of.h"
#include "lab/worlds.h"
#include "mlt/seeds/nothing_found.h"
#include "scenes/format/build_scene.h"

namespace wander {

template <World W>
void check_in(const Job& job, const InvarianceOptions& options, const Run& run,
              const KernelChecked& done) {
  const auto scene = build_scene<W>(job.scene());
  const Transport<W> space(*scene, Roulette::off);
  const Starts<Transport<W>> starts(space, options.seed);
  if (!starts.found_light())
    throw CommandFailure(
        ExitCode::failure,
        fmt::format("nothing can be checked: {} bidirectional samples found no light path from a "
                    "light to the sensor; {}",
                    starts.tried(), where_light_is_lost));
  check_kernels(space, family_of(job), starts, options, run, done);
}

}  // namespace wander
