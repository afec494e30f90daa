// What shows when a scene is walked through: glass whose sides contradict each other, and light that
// does not reach the sensor.  No shape alone tells either.
//
// Straight lines are followed from the sensor through whatever is transparent, and turn where they
// meet what is not, or anywhere on their way.  Each surface of glass says the index of refraction on
// both its sides; between two of them nothing changes it.  Where the next one says another, a face is
// turned over, two bodies overlap, or one is open.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/description.h"
#include "scenes/format/scene_file_fault.h"

namespace wander {

struct Probe {
  std::optional<double> index_at_sensor;              // none: no line met glass
  std::uint64_t samples = 0, samples_with_light = 0;  // bidirectional ones
  std::vector<Fault> warnings;
};

// Of a valid scene; the same at every call.
Probe probe(const description::Scene& scene);

}  // namespace wander
