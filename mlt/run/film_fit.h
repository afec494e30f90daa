// The normalization constant as the factor between two films: b in I_j ≈ b p_j, with I the film of
// the seed pass, p the film of the chains (of mean one), by least squares over the bins j.
//
// Sound where the obvious fits are not:
// - weights do not come from the data that they weigh: the groups are split into halves, and one
//   half's spread, smoothed over bins that lie side by side, weighs the other's film;
// - p has errors of its own: the variance of a residual is v_j + b² Var p_j [effective variance;
//   Orear 1982].  b is sought in it, too: with an iterate in its place, Σ p² would hold Σ Var p, and b
//   come out smaller by that share, a tenth where a pixel has a dozen steps;
// - the interval is a delete-a-group jackknife in which a group takes its slice of the seed pass and
//   its chains along, for a film's bins share samples and (JᵀJ)⁻¹ would know nothing of it; where
//   chains are short a part of b goes with products of what two groups found, which it would count
//   twice (statistics/jackknife.h).
// What is left is a bias of the order of Σ Var p / Σ p², the share of the chains' noise in the squares, for a bin's noise
// has to do with its variance, and with what samples found there, where a chain starts: so bins are taken together until
// that is a fraction of the error of b.  For study, and as a second opinion on the bridge.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace wander {

// One group: Σ of the seed pass over each bin, of so many samples; and what its chains deposited,
// in a unit that all groups share.
struct FilmFitGroup {
  std::vector<double> found;
  double samples;
  std::vector<double> deposits;
};

struct FilmFit {
  double b = 0;
  // b from all groups but one, drawn towards their mean by what products of two groups add.
  std::vector<double> without;
  std::size_t bins = 0;        // that were compared: fewer than there are where chains know little
  double chi2_per_degree = 0;  // of the residuals, as if bins were independent
  std::string failure;         // why there is no b; empty if there is
};

// By Ceres; needs two groups in each half, and two bins.  `shape` of the films: fastest axis last.
FilmFit fit_films(std::span<const FilmFitGroup> groups, std::span<const int> shape);

}  // namespace wander
