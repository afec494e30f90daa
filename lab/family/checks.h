// The tests of invariance of `check` in one world.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "lab/failure.h"
#include "lab/family/family_of.h"
#include "lab/worlds.h"
#include "mlt/seeds/nothing_found.h"
#include "scenes/format/build_scene.h"

namespace wander {

// Who asks for few samples does not wait for many.
inline StartsPilot pilot_for(std::uint64_t samples) {
  constexpr std::uint64_t tried_per_sample = 16, fewest_tried = 1 << 13, fewest_found = 64;
  const StartsPilot usual;
  return {.enough = std::clamp(samples, fewest_found, usual.enough),
          .most_tried = std::clamp(tried_per_sample * samples, fewest_tried, usual.most_tried)};
}

template <World W>
void check_in(const Job& job, const InvarianceOptions& options, const Run& run,
              const KernelChecked& done) {
  const auto scene = build_scene<W>(job.scene());
  const Transport<W> space(*scene, Roulette::off);
  const Starts<Transport<W>> starts(space, options.seed, pilot_for(options.samples));
  if (!starts.found_light())
    throw CommandFailure(
        ExitCode::failure,
        fmt::format("nothing can be checked: {} bidirectional samples found no light path from a "
                    "light to the sensor; {}",
                    starts.tried(), where_light_is_lost));
  check_kernels(space, family_of(job), starts, options, run, done);
}

}  // namespace wander
