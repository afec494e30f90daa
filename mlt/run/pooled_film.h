// The film of samples and chains together (partition.h).  Of one run
//
//   I_j = s (E_j + b S_j),
//   E_j = bins · Σ_g (light l w_B that samples of group g deposit on j) / Σ_g (its samples),
//   S_j = bins · Σ_g b_g D^M_gj / Σ_g b_g D_g,
//
// with D the deposits of its chains per step, D^M those that count w_M times, and b the normalization
// constant, which s makes the mean of the film.  The border has one of its own: w_B + w_M = 1, so
// b E_π[w_B] = ∫ f w_B, and
//   b = E̅ / (1 - S̅),
// bridge sampling (bridge.h) with the balance b / c of both sides that the pilot chose.  With it s is 1.
//
// Error.  Delete-a-group jackknife: a group takes its samples, its chains and its part in b along, so
// what they have in common is counted.  Of several runs, each with a c of its own, the film is the mean
// of theirs by their weights.
#pragma once

#include <span>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/group_findings.h"
#include "mlt/run/normalization.h"

namespace wander {

// The constant of the border.
Constant pooled_constant(std::span<const GroupFindings> groups,
                         std::span<const int> groups_of_runs);

struct PooledFilm {
  FilmEstimate film;
  double light_of_samples;         // the share of the light that samples carry, s E̅ / b
  std::vector<double> of_samples;  // what of the film they carry, s E_j
};

// `groups_of_runs`: how many groups are of the first run, of the second, …
PooledFilm pooled_film(std::span<const GroupFindings> groups, std::span<const int> groups_of_runs,
                       const Constant& constant, std::vector<int> shape);

// The mean of the film of paths of n vertices, the same way, for each n; of a large film, too.
std::vector<LengthShare> pooled_lengths(std::span<const GroupFindings> groups,
                                        std::span<const int> groups_of_runs,
                                        const Constant& constant);

}  // namespace wander
