// The tests of invariance of `check` in one world; each precision is made in a file of its own
// (world_checks_float.cpp, world_checks_double.cpp).
#pragma once

#include <fmt/format.h>

#include <functional>

#include "lab/failure.h"
#include "mlt/check/kernel_check.h"
#include "mutations/catalogue.h"
#include "scenes/format/build_scene.h"

namespace wander {

// Calls done(check) for each mutation, and for their mixture.
template <World W>
void check_family(const description::Scene& description, const Family& family,
                  const InvarianceOptions& options, const Run& run,
                  const std::function<void(KernelCheck)>& done) {
  const auto scene = build_flatland<W>(description);
  const Transport<W> space(*scene, Roulette::off);
  const Starts<Transport<W>> starts(space, options.seed);
  if (!starts.found_light())
    throw CommandFailure(
        ExitCode::failure,
        fmt::format("nothing can be checked: {} bidirectional samples found no light path from a "
                    "light to the sensor; look for walls without a gap, a light or sensor that "
                    "faces away, or a max_vertices that is too small",
                    starts.tried()));
  check_kernels(space, family, starts, options, run, done);
}

extern template void check_family<FlatlandSingle>(const description::Scene&, const Family&,
                                                  const InvarianceOptions&, const Run&,
                                                  const std::function<void(KernelCheck)>&);
extern template void check_family<Flatland>(const description::Scene&, const Family&,
                                            const InvarianceOptions&, const Run&,
                                            const std::function<void(KernelCheck)>&);

}  // namespace wander
