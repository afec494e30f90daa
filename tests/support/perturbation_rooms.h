// Rooms in which the perturbations are put to the proof: sensors and lamps in glass, across its
// surface and on curves, chains of several specular vertices, glasses of unequal index.
//
// Like those of test_scenes.h they are rooms of about the unit square with walls at odd angles.
#pragma once

#include <string>
#include <vector>

#include "core/description.h"

namespace wander::test {

// A pool of glass fills the lower part: the sensor at its floor, the lamp above, or the reverse.
description::Scene sensor_in_glass();
description::Scene lamp_in_glass();
// The sensor reaches from the glass into the air: a move of its point can change the medium.
description::Scene sensor_across_the_surface();
// Lamp and sensor on arcs, beside a mirror.
description::Scene curved_ends();
// Two mirrors face each other: chains of several reflections, with diffuse walls between.
description::Scene mirror_corridor();
// A curtain of glass beads whose indices alternate: what one chain of events enters, another does
// not.
description::Scene beads_of_two_glasses();

struct NamedRoom {
  std::string name;
  description::Scene (*make)();
};
// These, and of test_scenes.h those that matter to the perturbations.
std::vector<NamedRoom> perturbation_rooms();

}  // namespace wander::test
