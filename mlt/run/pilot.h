// A pilot: a small run with random numbers of its own, that decides how samples and chains share the
// film (partition.h) and is then thrown away, so that what is decided does not know what it weighs.
#pragma once

#include <span>

#include "mlt/run/group_findings.h"
#include "mlt/run/partition.h"

namespace wander {

// The seed of the pilot of a run with this seed.
std::uint64_t seed_of_pilot(std::uint64_t seed);

// From what its groups of one chain each found, each with a part of each border, after so many steps of each.
Pilot pilot_of(std::span<const GroupFindings> groups, double rays, std::uint64_t steps);

// τ and τ' of the chains' part with border k, from the variance of the groups' films between each other,
// over that of a single draw,
//   R  = Σ_j Var_g(D^M_gj) / (E_π[w_M²] - Σ_j (mean of D^M_gj)²),
//   R' = Var_g(Σ_j D^M_gj) / Var_π(w_M),
// where D^M_gj is what group g deposits on bin j with the weight w_M, as a share of all its deposits.
Pilot::Border border_of(std::span<const GroupFindings> groups, std::size_t border,
                        const RatioHistogram& states, std::uint64_t steps);

// `late` as it would be after so many steps of each chain.  Where chains mix τ is the same after any
// number of steps.  Where they do not it grows with them, for what they know of how much light lies
// where is what their seeds knew: τ is taken to go on growing as the power of the steps by which it has
// grown since `early`, the same pilot before.  Of light that samples have found beyond a border and chains
// have not, chains know nothing, whatever their τ elsewhere: with this border and with all before it.  Of
// the power and of that light a quarter may be noise, and what is above is stretched to 0 … 1; of a
// border beyond which there is hardly any light, all.  τ is no more than the steps of a chain, which tell
// as much as one draw at least.
Pilot extrapolated(const Pilot& early, const Pilot& late, double steps_per_chain);

}  // namespace wander
