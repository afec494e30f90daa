// One property of a scene, on its way to its extreme.
#pragma once

#include <vector>

#include "core/description.h"

namespace wander::test {

// All paths of a scene, or those of its greatest length alone.
enum class PathsOf { any_length, greatest_length };

struct Sweep {
  const char* name;
  description::Scene (*make)(double setting);
  std::vector<double> settings;
  PathsOf paths = PathsOf::any_length;
};

// The same five, in plane_sweeps.cpp and space_sweeps.cpp; the setting 0.1 of `angle` is a room whose
// cosines are of that size.
std::vector<Sweep> plane_sweeps();
std::vector<Sweep> space_sweeps();

}  // namespace wander::test
