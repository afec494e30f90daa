// A pilot: a small run with random numbers of its own, that decides how samples and chains share the
// film (partition.h) and is then thrown away, so that what is decided does not know what it weighs.
#pragma once

#include <span>

#include "mlt/run/group_findings.h"
#include "mlt/run/partition.h"

namespace wander {

// The seed of the pilot of a run with this seed.
std::uint64_t seed_of_pilot(std::uint64_t seed);

// From what its groups found, each with one chain, or one of each length, after so many steps of each
// group.
Pilot pilot_of(std::span<const GroupFindings> groups, double rays, std::uint64_t steps);

// τ, from the variance of the groups' films between each other, over that of a single draw,
//   R = Σ_j Var_g(share of bin j) / Σ_j p_j (1 - p_j).
double steps_per_draw_of_film(std::span<const GroupFindings> groups, std::uint64_t steps);

}  // namespace wander
