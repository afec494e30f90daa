// Whether anything can see the back of a surface.
//
// Mitsuba's opaque bsdfs are black from behind unless they are `twosided`; materials here reflect on
// both sides.  That is a difference only where something lies behind: the answer is on the safe side,
// for what lies behind may be hidden.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/geometry/triangles.h"

namespace wander {

// A shape as far as it matters here.
struct PlacedSurface {
  enum class Enclosure { open, front_outside, front_inside };
  enum class Back { dark, same };  // the same as the front

  std::vector<glm::dvec3> points;  // some of it
  Back back = Back::same;
  Enclosure enclosure = Enclosure::open;
  Triangles facets;    // their front is outside; none if there are too many to look at
  double radius = -1;  // of a sphere, which has no facets
  glm::dvec3 center{0};
};

// What encloses what is only found out of meshes with a dark back.
PlacedSurface placed_mesh(Triangles mesh, PlacedSurface::Back back);
PlacedSurface placed_sphere(glm::dvec3 center, double radius, PlacedSurface::Enclosure enclosure);

// Of all surfaces, whether they have a dark back that another surface, or an eye, may be behind.
std::vector<bool> seen_from_behind(std::span<const PlacedSurface> surfaces,
                                   std::span<const glm::dvec3> eyes);

}  // namespace wander
