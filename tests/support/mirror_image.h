// Two specular scenes in closed form, up to one quadrature over the sensor.
//
// One mirror: light of an emitter arrives as if from its mirror image, through the aperture that
// the mirror is.  Under angles θ from the receiver's normal,
//   E = R Le Σ (sin θ2 - sin θ1)  over  [image] ∩ [mirror] \ [what blocks the way to the mirror].
// One refraction at a line, receiver inside the medium η_t (Snell, Fresnel, basic radiance L/η):
//   E = Le ∫ (1 - F(θ_i)) (η_t/η_i) cos θ_t dθ_t  over the angles whose refracted ray meets the
//   emitter.
// The factor η_t/η_i is the first power in the plane; F is the unpolarised mean.
#pragma once

#include <cstddef>
#include <vector>

#include "core/exact/plane.h"

namespace wander::test {

using namespace exact;

// The emitter is black behind, blocks from both sides, and shines from its front; it is also the
// only thing that blocks the way from sensor to mirror, and nothing blocks the way from mirror to
// emitter.
struct MirrorScene {
  PlaneSegment mirror;
  double reflectance = 1;
  PlaneSegment emitter;
  double radiance = 1;
};

// Light that came by exactly one reflection, W/m.
double mirror_point_irradiance(const MirrorScene& scene, const Receiver& receiver);
// Its mean over equal bins of the front of the sensor, from → to.
std::vector<double> mirror_film(const MirrorScene& scene, const PlaneSegment& sensor,
                                std::size_t bins);

// A horizontal interface; the emitter lies above it and faces it, the receivers look up from below.
struct RefractionScene {
  PlaneSegment interface;  // from left to right
  double index_above = 1, index_below = 1.5;
  PlaneSegment emitter;
  double radiance = 1;
};

// Unpolarised Fresnel reflectance of light that arrives under cos θ_i; `index` is η_t / η_i.
double fresnel_reflectance(double cosine, double index);
double refraction_point_irradiance(const RefractionScene& scene, PlanePoint receiver);
// Means over bins of a horizontal line below, between neighbouring `edges`.
std::vector<double> refraction_film(const RefractionScene& scene, double height,
                                    const std::vector<double>& edges);

}  // namespace wander::test
