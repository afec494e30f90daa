// The fluence rate of a scene in the plane, the light in the space between the surfaces:
//
//   φ(x) = ∫ L(x, ω) dω   over all directions,   W/m
//
// A walk from the lights carries the flux Φ_i = Π_{k<=i} value_k geometry_k / Π_{k<=i+1}
// from_light_k along its edge i, and the mean of φ over a cell is the expected track length in it,
//
//   <φ>_cell = E[ Σ_i Φ_i |edge_i ∩ cell| ] / |cell|   [track-length estimator: Spanier 1966].
//
// Walks are spread evenly, batch by batch (light_walks.h): the error is the spread of the batches.
//
// The point in the open counts as a vertex: max_vertices bounds what arrives there as it bounds
// what arrives at the sensor.  In glass of index n, φ is n times as large at equilibrium, as L is.
#pragma once

#include "core/description.h"
#include "core/geometry/plane_grid.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

// The mean of φ over each cell: a film of shape {rows, columns}; `by_length` counts the point.
Rendering estimate_fluence(const description::Scene& scene, const PlaneGrid& grid,
                           const Session& session);

}  // namespace wander
