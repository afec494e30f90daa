// Doubts about a run of chains, each with its remedy.  A run that looks clean may still depend on
// its seed; here it is asked what it has seen, and whether its groups tell the same.
#pragma once

#include <string>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/seeds/seed_pass.h"
#include "mlt/watch/functionals.h"
#include "mlt/watch/statistics.h"

namespace wander {

struct Evidence {
  const SeedTally& seeds;
  const ChainDraws& draws;
  const ChainsRecord& chains;
  const MutationStatistics& statistics;
  std::size_t chains_per_group;  // of the draws
  // Also those of which there are no draws that could be compared.
  std::size_t all_chains = draws.chains();
  std::size_t all_groups = draws.chains() / chains_per_group;
  double light_of_chains = 1;  // the share of the film that is theirs, if it is pooled
};

// How well chains mix tells nothing of a film of which they have less than this; what they spoil of it still shows in
// its error (dominated_film).
inline constexpr double least_light_of_chains = 0.05;

std::vector<std::string> warnings(const Evidence& evidence);

// That a few groups decide the error of the film: one has met bright light that the others seldom have,
// and nobody knows how much more of it there is.  Empty where it is not so.
std::string dominated_film(const FilmEstimate& film, int groups);
// R̂ above this says that chains are short for their mixing [Vehtari et al. 2021].
inline constexpr double largest_r_hat = 1.01;

// A seed pass that fewer samples carry has not seen what it may have missed.
bool rests_on_few_samples(const SeedTally& seeds);

// Do the groups agree?  The share of a group's draws that falls into a cell of the functional is
// compared with the other groups', and its first half with its second.  If chains mix,
//   F = variance of the groups' shares / (mean of (first half - second half)² / 4)
// is about 1, with G - 1 and G degrees of freedom; where every group stays by itself, halves agree
// and groups do not.  The cells are equally probable, so that none is rare.
struct Disagreement {
  double ratio = 1;    // √F of the worst cell
  double p_value = 1;  // of it, times the number of cells
};
Disagreement disagreement(const Draws& draws, std::size_t chains_per_group);
// A right run is accused this rarely, by each functional.
inline constexpr double disagreement_false_alarm = 1e-6;

}  // namespace wander
