// A pilot: a small run with random numbers of its own, that decides how samples and chains share the
// film (partition.h) and is then thrown away, so that what is decided does not know what it weighs.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mlt/run/bin_worth.h"
#include "mlt/run/partition.h"
#include "mlt/run/trial_log.h"

namespace wander {

// The seed of the pilot of a run with this seed.
std::uint64_t seed_of_pilot(std::uint64_t seed);

// Of each chain: those it has made, and those that it is to have made when the pilot ends.
struct PilotSteps {
  std::uint64_t so_far = 0, in_all = 0;
};

// From what its groups of one chain each found.
// `is_over`: nobody wants to know any more, and what is told is of no use.
Pilot pilot_of(std::span<const TrialFindings> groups, const BinWorth& worth, PilotSteps steps,
               const std::function<bool()>& is_over);

// τ and τ' of the chains' part with each border, from the variance of the groups' films between each other
// (deposit_spread.h), over that of a single draw,
//   R  = Σ_j a_j Var_g(D^M_gj) / (E_π[a w_M²] - Σ_j a_j (mean of D^M_gj)²),
//   R' = Var_g(Σ_j D^M_gj) / Var_π(w_M),
// with the states of `pilot`, which are weighed by a.  A chain of few steps has not come far from where it began, and
// one that was caught alone would speak for all: Var_g is but for the one that is farthest off.  In long chains it is what
// the chains of a run will do, too, and more often: Var_g is of all, and they are asked how evenly they know the
// hard light.  Chains are long if they are meant to be when the pilot ends (`in_all`; a budget of time may end it before), so
// that one Var_g is held against the same of an earlier part.
inline constexpr std::uint64_t steps_of_long_pilot = 1 << 14;  // of each chain
std::vector<Pilot::Border> borders_of(std::span<const TrialFindings> groups, const BinWorth& worth,
                                      const Pilot& pilot, std::span<const Partition> borders,
                                      const std::function<bool()>& is_over);

// `late` as it would be after so many steps of each chain.  Where chains mix τ is the same after any
// number of steps.  Where they do not it grows with them, for what they know of how much light lies
// where is what their seeds knew: τ is taken to go on growing as the power of the steps by which it has
// grown since `early`, the same pilot before, and in a run whose chains are shorter to be less by that power.
// Of light that samples have found beyond a border and chains have not, chains know nothing, whatever their τ
// elsewhere: with this border and with all before it.  The same is said of light that few of them have come to,
// and of which only these few spoil the film.  Of the power and of that light a quarter may be noise, of the
// evenness half, and what is above is stretched to 0 … 1; of a border beyond which there is hardly any light, all.
// τ is no more than the steps of a chain, which tell as much as one draw at least.
Pilot extrapolated(const Pilot& early, const Pilot& late, double steps_per_chain);

}  // namespace wander
