// Small Flatland scenes for the tests of chains and mutations.
//
// All are rooms of about the unit square, so that one set of functions of a path serves them all.
// Walls meet at odd angles: no symmetry may hide a mistake.  Lights and sensors scatter, too.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/description.h"
#include "core/scene.h"

namespace wander::test {

using FlatScene = std::unique_ptr<const Scene<Flatland>>;

// A closed room of diffuse walls of several reflectances, with two lights of unequal radiance.
description::Scene diffuse_room();
// Two rooms, joined by a gap above the wall between them.
description::Scene room_with_gap();
// A mirror, a circle of glass, and a wall of rough metal.
description::Scene mirror_and_glass();
// A wall of rough metal, a circle of rough glass, and an arc of rough metal.
description::Scene rough_room();
// Seen by a camera: a pinhole, or a thin lens.
description::Scene pinhole_room();
description::Scene thin_lens_room();
// The light is behind a closed wall.
description::Scene dark_room();
// Segments only, at right angles or not: turned by a quarter, each number stays what it was.
description::Scene angular_room();

struct NamedScene {
  std::string name;
  description::Scene scene;
};
// The scenes in which light arrives.
std::vector<NamedScene> lit_scenes();

FlatScene build(const description::Scene& scene);

// Every length multiplied by `factor`; the radiance of every light multiplied; the whole scene
// turned left by a quarter.
description::Scene scaled(description::Scene scene, double factor);
description::Scene brightened(description::Scene scene, double factor);
description::Scene turned(description::Scene scene);

}  // namespace wander::test
