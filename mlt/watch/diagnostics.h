// How well chains have mixed, from the draws of a scalar: the diagnostics of Vehtari, Gelman,
// Simpson, Carpenter and Bürkner, "Rank-normalization, folding, and localization: an improved R̂"
// (Bayesian Analysis 2021), with the conventions of ArviZ 0.23, whose numbers these are.
//
// Chains are split in two halves before anything is compared.  Draws that are not finite, or that
// are all the same, tell nothing: the answer is NaN.  So it is with fewer than 4 draws a chain,
// and, for R̂, with fewer than 2 chains.
#pragma once

#include <cstddef>
#include <vector>

namespace wander {

// Values of a scalar along chains of one length, [chain][draw].
struct Draws {
  std::size_t chains = 0, length = 0;
  std::vector<double> values{};

  const double* chain(std::size_t c) const { return values.data() + c * length; }
};

// R̂ = √(var⁺ / W): the variance that all chains together show, var⁺ = W (N-1)/N + B/N, over the
// variance W within a chain; B/N is the variance of the chains' means.  Infinite where every chain
// stands still, but not at the same place.
double split_r_hat(const Draws& draws);
// The larger of R̂ of the normal scores and of the normal scores of |x - median|: differences of
// location and of scale, of any distribution.
double rank_r_hat(const Draws& draws);

// Effective sample sizes: so many independent draws would know as well …
double ess_mean(const Draws& draws);  // … the mean
double ess_sd(const Draws& draws);    // … the standard deviation
double ess_quantile(const Draws& draws, double probability);
double ess_bulk(const Draws& draws);  // … the mean of the normal scores
double ess_tail(const Draws& draws);  // … the worse known of the 5 % and the 95 % quantile

// Monte Carlo standard errors of the estimates made of all draws.
double mcse_mean(const Draws& draws);
double mcse_sd(const Draws& draws);
double mcse_quantile(const Draws& draws, double probability);

// ρ_t = 1 - (W - ĉ_t) / var⁺, t = 0 … lags, of all chains together: what sets them apart stays at all lags.  ρ_0 is
// 1; empty where the draws tell nothing.
std::vector<double> combined_autocorrelation(const Draws& draws, std::size_t lags);

// Integrated autocorrelation time τ = 1 + 2 Σ ρ_t, in draws: the mean of n draws has the variance
// of n / τ independent ones.
//
// By Geyer's initial monotone sequence (1992), across chains: the number of draws / ess_mean.
double autocorrelation_time(const Draws& draws);
// By Sokal's window (1989), within chains: τ(M) = 1 + 2 Σ_{t ≤ M} ρ_t at the least M ≥ 5 τ(M).  NaN
// if the chains are shorter than 50 τ: then the window has not seen how slow they are.
double sokal_autocorrelation_time(const Draws& draws);

}  // namespace wander
