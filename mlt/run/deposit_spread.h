// How much what chains deposit on the bins of a film differs from chain to chain, with each of several
// borders (partition.h).
#pragma once

#include <span>
#include <vector>

#include "mlt/run/bin_worth.h"
#include "mlt/run/partition.h"
#include "mlt/run/trial_log.h"

namespace wander {

// With D_gj what group g deposits on bin j, as a share of all that it deposits, D^M_gj what of it counts w_M
// times, and a_j what an error on the bin is worth.  Var_g is a variance between groups.
struct DepositSpread {
  // Of all groups, and but for the one that is farthest from the mean of all.
  struct Variance {
    double of_all = 0, but_for_one = 0;
  };
  double worth = 0;  // Σ_j a_j (mean of D_gj), which is E_π[a] as the groups know it; and over it
  Variance film{};   // Σ_j a_j Var_g(D^M_gj)
  double squared_mean = 0;  // Σ_j a_j (mean of D^M_gj)²
  Variance total{};         // Var_g(Σ_j D^M_gj)
  // With s_g what group g adds to `film`, (Σ s)² / Σ s² over the number of groups: 1 where all add alike.
  double evenness = 1;
};

// (Σ x)² / Σ x² over their number, of what is not negative: 1 where all are alike, and where there is nothing.
double evenness(std::span<const double> values);

// Of each border, by the groups that deposited anything; none where there are not three.
std::vector<DepositSpread> deposit_spreads(std::span<const TrialFindings> groups,
                                           const BinWorth& worth,
                                           std::span<const Partition> borders);

}  // namespace wander
