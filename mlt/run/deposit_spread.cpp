#include "mlt/run/deposit_spread.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "mlt/run/partition.h"
#include "statistics/squared.h"

namespace wander {

namespace {

struct DepositShare {
  int bin;
  std::size_t group;
  double share, ratio;  // of all deposits of the group; l
};

// Bin by bin, and in each group by group.
struct DepositShares {
  std::vector<DepositShare> all{};
  std::size_t groups = 0;  // that deposited anything
};

DepositShares shares_of(std::span<const TrialFindings> groups) {
  DepositShares shares;
  for (const TrialFindings& group : groups) {
    double mass = 0;
    for (const TrialLog::Deposit& deposit : group.log->deposits) mass += deposit.weight;
    if (!(mass > 0)) continue;
    for (const auto& [bin, weight, ratio] : group.log->deposits)
      shares.all.push_back({bin, shares.groups, weight / mass, ratio});
    ++shares.groups;
  }
  std::ranges::stable_sort(shares.all, {}, &DepositShare::bin);
  return shares;
}

// How far each group is from the mean of all, squared.
class Distances {
 public:
  explicit Distances(std::size_t groups) : squares_(groups) {}

  void add(std::size_t group, double square) { squares_[group] += square; }
  void add_to_all(double square) {
    for (double& of_group : squares_) of_group += square;
  }
  DepositSpread::Variance variance(double unit) const {
    const auto count = static_cast<double>(squares_.size());
    const double all = std::accumulate(squares_.begin(), squares_.end(), 0.0);
    const double farthest = std::ranges::max(squares_);
    return {all / (count - 1) / unit, (all - farthest) / (count - 2) / unit};
  }
  double evenness() const { return wander::evenness(squares_); }

 private:
  std::vector<double> squares_;
};

// visit(those) of each run with the same key.
template <class Key, class Visit>
void for_each_run(std::span<const DepositShare> shares, Key&& key, Visit&& visit) {
  for (std::size_t begin = 0; begin < shares.size();) {
    std::size_t end = begin;
    while (end < shares.size() && key(shares[end]) == key(shares[begin])) ++end;
    visit(shares.subspan(begin, end - begin));
    begin = end;
  }
}

DepositSpread spread_of(const DepositShares& shares, const BinWorth& worth, Partition side) {
  const auto count = static_cast<double>(shares.groups);
  DepositSpread spread;
  Distances film(shares.groups), total(shares.groups);
  std::vector<double> on_bin_of(shares.groups), totals(shares.groups);  // D^M
  for_each_run(shares.all, std::mem_fn(&DepositShare::bin), [&](std::span<const DepositShare> run) {
    double all = 0, hard_of_all = 0;
    for (const auto& [bin, group, share, ratio] : run) {
      const double hard = share * side.of_chains(ratio);
      on_bin_of[group] += hard;
      all += share;
      hard_of_all += hard;
    }
    const double a = worth(run.front().bin), mean = hard_of_all / count;
    for (const DepositShare& deposit : run) {
      double& hard = on_bin_of[deposit.group];  // once for each group
      film.add(deposit.group, a * (hard - 2 * mean) * hard);
      totals[deposit.group] += hard;
      hard = 0;
    }
    film.add_to_all(a * squared(mean));
    spread.worth += a * all / count;
    spread.squared_mean += a * squared(mean);
  });
  const double mean_total = std::accumulate(totals.begin(), totals.end(), 0.0) / count;
  for (std::size_t g = 0; g < shares.groups; ++g) total.add(g, squared(totals[g] - mean_total));
  spread.film = film.variance(spread.worth);
  spread.squared_mean /= spread.worth;
  spread.evenness = film.evenness();
  spread.total = total.variance(1);
  return spread;
}

}  // namespace

double evenness(std::span<const double> values) {
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += squared(value);
  }
  return squares > 0 ? squared(sum) / (squares * static_cast<double>(values.size())) : 1;
}

std::vector<DepositSpread> deposit_spreads(std::span<const TrialFindings> groups,
                                           const BinWorth& worth,
                                           std::span<const Partition> borders) {
  const DepositShares shares = shares_of(groups);
  std::vector<DepositSpread> spreads;
  if (shares.groups < 3) return spreads;
  for (const Partition& side : borders) spreads.push_back(spread_of(shares, worth, side));
  return spreads;
}

}  // namespace wander
