// Direct light in the plane, exactly.
//
// Point irradiance: a Lambertian segment seen unobstructed under angles θ1 … θ2 from the receiver's
// normal gives E = Le (sin θ2 - sin θ1), W/m (∫ L cos θ dθ).  What is visible of a scene of
// segments is a finite set of angular intervals, so occlusion costs no accuracy. Unoccluded pairs:
// ∫∫ G dl dl' = |crossed strings| - |uncrossed strings| [Hottel 1954].
#pragma once

#include <span>

#include "core/exact/plane.h"

namespace wander::test {

using namespace exact;

// A one-sided Lambertian emitter that blocks from both sides; a mere occluder has radiance 0.
struct LambertSegment {
  PlaneSegment segment;
  double radiance = 0;
};

double point_irradiance(const Receiver& receiver, std::span<const LambertSegment> scene);

// The mean over the front of `sensor`, which is no part of the scene and blocks nothing; adaptive.
double mean_irradiance(const PlaneSegment& sensor, std::span<const LambertSegment> scene);

// ∫∫ G dl dl' of two segments of which each lies wholly in front of the other; no occlusion.
double crossed_strings(const PlaneSegment& a, const PlaneSegment& b);

}  // namespace wander::test
