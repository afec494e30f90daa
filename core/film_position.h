// Where a vertex on the sensor, or on the lens of a camera, is on the film, in [0,1)^(D-1); and what an importance map
// says of it (importance_map.h).
#pragma once

#include "core/importance_map.h"
#include "core/path.h"
#include "core/scene.h"

namespace wander {

// Of x_i, the last of its path; of a camera, by the edge that comes to it.
template <World W>
typename W::Square film_position_at(const Scene<W>& scene, const Path<W>& x, int i) {
  const auto& place = x[i].place;
  if (place.shape == no_shape)
    return *scene.camera()->film_coordinate(place.position, -x[i - 1].place.to_sensor);
  return visit_shape([&](const auto& s) { return s.parameter(place.position, place.primitive); },
                     scene.shape(place.shape));
}

// v of the bin it lies on.
template <World W>
typename W::Real importance_at(const Scene<W>& scene, const Path<W>& x, int i,
                               const ImportanceMap& importance) {
  return static_cast<typename W::Real>(importance(scene.bin(film_position_at(scene, x, i))).v);
}

}  // namespace wander
