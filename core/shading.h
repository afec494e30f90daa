// The normal about which a surface scatters, where that is not its own: on smooth meshes.
//
// Sides, visibility and G stay with the normal N of the surface, for paths are made of points and
// areas.  A material is asked about the shading normal S instead.  It says its value and its densities
// with respect to the projected angle |ω·S| dω, so what a path keeps of them, being with respect to
// |ω·N| dω, is [Veach 1997, 5.3, eq. 5.17 to 5.19]
//   value          f_s |L·S| / |L·N|    L: to the light, for value · |L·N| dω is to be f_s |L·S| dω
//   toward_sensor  p_s |E·S| / |E·N|    E: to the sensor
//   toward_light   p_s |L·S| / |L·N|
// A path has one value, whichever end it is sampled from, so all techniques have the same film.  Its
// adjoint, with L and E exchanged, is another function: f_s |E·S| / |E·N|.  The δ of a specular event
// is that about S (material.h, with |ω·S| dω for dσ⊥); it is one formal factor of all three, as everywhere.
//
// A direction on different sides of the surface by N and by S would carry light through it, or
// into it: there value and densities are 0, and a sample of such a direction, or for one, ends its walk.
//
// The shading normal is found anew from the point.  Paths hold nothing of it, and a scene of flat
// surfaces pays with a test of a flag per vertex, one of the plane with nothing.
#pragma once

#include <cmath>

#include "core/path.h"
#include "core/scene.h"

namespace wander {

// About a normal of the surface at that place.  (The poles of a sphere have no edge, and do not turn.)
template <World W>
Frame<W::dimension, typename W::Length> frame_at(const Scene<W>& scene, const Place<W>& place,
                                                 typename W::Direction normal) {
  const auto edge = [&] {
    return visit_shape(
        [&](const auto& s) -> typename W::Direction {
          if constexpr (requires { s.edge(place.primitive); })
            return s.edge(place.primitive);
          else
            return typename W::Direction(1);  // any
        },
        scene.shape(place.shape));
  };
  return {normal, edge};
}

template <World W>
class ShadingFrame {
 public:
  using Real = typename W::Real;
  using Length = typename W::Length;
  using Direction = typename W::Direction;
  using Local = typename W::Local;

  ShadingFrame(const Scene<W>& scene, const Place<W>& place)
      : normal_(place.normal),
        is_smooth_(W::dimension == 3 && scene.surface(place.shape).is_smooth),
        frame_(frame_at(
            scene, place,
            is_smooth() ? shading_normal(scene.shape(place.shape), place) : place.normal)) {}

  Local to_local(Direction direction) const { return frame_.to_local(direction); }
  // Of unit length.
  Direction to_world(Local direction) const { return glm::normalize(frame_.to_world(direction)); }

  // Is the direction on one side of the surface by both normals?
  bool agrees(Direction direction) const {
    return !is_smooth() || glm::dot(direction, normal_) * glm::dot(direction, frame_.normal) > 0;
  }
  // |ω·S| / |ω·N|, or 0 where the two disagree.
  Real stretch(Direction direction) const {
    if (!is_smooth()) return 1;
    const Length own = glm::dot(direction, normal_), shading = glm::dot(direction, frame_.normal);
    return own * shading > 0 ? static_cast<Real>(shading / own) : Real(0);
  }
  // What a material says, as a path keeps it.
  Scattering<W> stretched(Scattering<W> s, Direction to_light, Direction to_sensor) const {
    if (!is_smooth()) return s;
    const Real light = stretch(to_light), sensor = stretch(to_sensor);
    if (!(light > 0 && sensor > 0)) return {};
    s.value *= light;
    s.toward_light *= light;
    s.toward_sensor *= sensor;
    return s;
  }

 private:
  bool is_smooth() const {
    if constexpr (W::dimension == 3)
      return is_smooth_;
    else
      return false;
  }
  static Direction shading_normal(const Shape<W>& shape, const Place<W>& place) {
    return visit_shape(
        [&](const auto& s) -> Direction {
          if constexpr (requires { s.shading_normal(place.position, place.primitive); })
            return s.shading_normal(place.position, place.primitive);
          else
            return place.normal;
        },
        shape);
  }

  Direction normal_;
  bool is_smooth_;
  Frame<W::dimension, Length> frame_;
};

}  // namespace wander
