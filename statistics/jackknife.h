// The delete-a-group jackknife [Quenouille 1956; Tukey 1958]: of G independent groups each is left
// out once, and
//   Var θ = (G - 1)/G Σ_g (θ_(g) - mean θ_(·))².
//
// Groups may count for more or less in θ, by weights that do not depend on what they found.  With
// W = Σ w_g it is
//   Var θ = Σ_g (1 - w_g/W) (θ_(g) - mean θ_(·))²,
// where the mean weighs θ_(g) by W - w_g.  Of a weighted mean that is Σ (w_g/W)² (x_g - θ)² but for
// terms of the order w_g/W, so it holds however the spread of a group goes with its weight.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wander {

// √Var θ of many θ, which the same groups tell.
class Jackknife {
 public:
  // No weights: they are equal.
  explicit Jackknife(std::size_t groups, std::span<const double> weights = {});

  // From the θ_(g).  One group alone tells nothing: NaN.
  double error(std::span<const double> without) const;
  // Of as many θ as there are errors: their θ_(g) side by side, group by group.
  void errors(std::span<const double> without, std::span<double> errors) const;

 private:
  std::vector<double> rests_;  // W - w_g, in units of what it is with equal weights
};

// The same of one θ.
double jackknife_error(std::span<const double> without, std::span<const double> weights = {});

// θ without two groups.
struct LeftOutPair {
  std::size_t first, second;
  double without;
};

// What products of two groups' findings add to θ, Var θ has once and the jackknife counts twice [Efron and
// Stein 1981].  Once is
//   Σ_{g<h} Q_gh² / G²,  Q_gh = G θ - (G - 1)(θ_(g) + θ_(h)) + (G - 2) θ_(gh),
// to leading order in 1/G, which some pairs tell, if no outcome chose them.  Draws the θ_(g) towards their
// mean, so that jackknife_error counts them once, too, and never leaves less than a tenth of the variance.
void count_products_once(std::span<double> without, double theta,
                         std::span<const LeftOutPair> pairs);

// How many degrees of freedom the variance has: groups that move θ more than others count for
// less.  (Σ v_g)² / Σ v_g² - 1 with v_g the squared deviations, never more than G - 1.
double jackknife_degrees(std::span<const double> squared_deviations);

// Shares of a whole: θ_k = b Σ_g x_gk / Σ_g Σ_k x_gk, with b an estimate of its own.
class RatioJackknife {
 public:
  // x_gk, by group and part; a group's weight is in its x_gk already.
  explicit RatioJackknife(const std::vector<std::vector<double>>& groups,
                          std::span<const double> weights = {});

  double value(std::size_t part) const;  // θ_k / b
  // θ_k / b without a group; NaN if nothing is left.
  double without(std::size_t part, std::size_t group) const;
  // Of θ_k, where `b` is what b becomes without each group.
  double error(std::size_t part, std::span<const double> b) const;

 private:
  const std::vector<std::vector<double>>& groups_;
  Jackknife jackknife_;
  std::vector<double> totals_, masses_;  // by part; by group
  double mass_ = 0;
};

}  // namespace wander
