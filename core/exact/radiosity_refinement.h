// A mesh made for one film: elements are bisected where their error weighs in it.
//
// With L_h the radiances on a mesh, the residual at y is what a fresh gathering of L_h differs from
// its interpolation, r_k(y) = (T L_h)_k(y) - E_k(y).  Reaching the sensor it changes the film by
//   ∫ ρ/2 r_k(y) W_j(y) dl,   W_j: the irradiance at y if the sensor shone with radiance 1,
// over all orders with k + j + 1 <= max_vertices: transport is its own adjoint.  Σ |…| over the
// elements bounds what the mesh gets wrong of the flux on the sensor, to first order, however it is
// distributed [dual-weighted residuals: Becker and Rannacher 2001, for radiosity Lischinski et al.
// 1994].  So kinks and narrow penumbras of light that was reflected before, which are in no
// discontinuity mesh, are found where they matter and nowhere else.
#pragma once

#include <cstddef>

#include "core/exact/radiosity.h"

namespace wander::exact {

struct Refinement {
  double tolerance = 1e-5;           // of the flux on the sensor, relative
  std::size_t most_unknowns = 6000;  // ends the refinement, wherever it is
};

// Of a scene with one sensor; throws std::invalid_argument if even the first mesh has too many
// unknowns.  The error of each bin is the difference between the last two meshes
// plus the bin's value times the bound.
RadiositySolution solve_radiosity_adaptively(const RadiosityScene& scene,
                                             const Refinement& refinement = {});

}  // namespace wander::exact
