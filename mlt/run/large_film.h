// The film of a large scene, from films that groups share (shared_films.h), and its error bars from
// how those differ: the same estimates as of films that each group has to itself (deposit.h,
// normalized_film.h), with fewer and fatter parts.
#pragma once

#include <span>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/normalization.h"
#include "mlt/run/shared_films.h"

namespace wander {

// Of one run: its films, and the light on a bin that a deposit stands for.
struct SharedLight {
  const SharedFilms* films;
  double scale;
  double weight = 1;  // of each group, among those of other runs (group_findings.h)
  // Of a pooled film, for which `films` are the chains' part: the samples', and all of the chains.
  const LargeSampleFilm* samples = nullptr;
  const TotalFilm* total = nullptr;
};

// The mean of the films of a run, of which each is a mean of groups with constants of their own.
FilmEstimate mean_film(const SharedLight& run, std::vector<int> shape);

// Scaled to the constant, whose `without` are of the groups of the first run, then of the second, …
FilmEstimate normalized_film(std::span<const SharedLight> runs, const Constant& constant,
                             std::vector<int> shape);

// What the constant would be without the groups of each film: the delete-a-group jackknife, taken
// further to several groups at once, to the first order, in which each group pulls by itself.  Of
// groups of weight w, k of which are left out, with W the weight of all,
//   b without them ≈ b + (W - w)/(W - k w) Σ over the k (b without it - b).
std::vector<double> without_films(std::span<const SharedLight> runs, const Constant& constant);

}  // namespace wander
