// Chains of MMLT [Hachisuka, Kaplanyan and Dachsbacher 2014]: a group has one for each length of
// paths, with a seed and a constant b_{g,n} of its own, both from the group's slice.
//
// Each step goes to one length: step j to the one in whose interval of the pmf q the number
// U + j φ mod 1 lies, with U uniform and φ the golden ratio.  Then the steps of length n are q_n N
// of N in expectation, exactly, and never far from it (Kronecker's sequence); a deposit has weight
// b_{g,n} / (q_n N), and the film is unbiased for any N.  q is a mixture of the light that all
// other groups found of that length and of equal shares; it must not know the group's own slice.
#pragma once

#include "mlt/primary/multiplexed_chain.h"
#include "mlt/primary/primary_estimator.h"
#include "mlt/run/group.h"

namespace wander {

// The share of steps that is spread over all lengths, whatever light they seem to carry.
inline constexpr double even_share_of_steps = 0.1;

// q_n at n - 2.
inline std::vector<double> shares_of_steps(const SeedTally& others) {
  std::vector<double> q(others.sum.size());
  const double total = others.total.value();
  const double even = total > 0 ? even_share_of_steps : 1;
  for (std::size_t k = 0; k < q.size(); ++k)
    q[k] = even / static_cast<double>(q.size()) +
           (total > 0 ? (1 - even) * others.sum[k].value() / total : 0);
  return q;
}

// The length of each step.
class LengthSequence {
 public:
  LengthSequence(std::vector<double> shares, double first)
      : shares_(std::move(shares)), place_(static_cast<std::uint64_t>(first * 0x1p64)) {}

  // step(n - 2), so many times.
  template <class Step>
  void take(std::uint64_t steps, Step&& step) {
    for (std::uint64_t i = 0; i < steps; ++i) step(next());
  }
  // n - 2
  std::size_t next() {
    double u = static_cast<double>(place_ >> 11) * 0x1p-53;
    place_ += 0x9E3779B97F4A7C15;  // φ - 1, as a fraction of 2^64
    std::size_t k = 0;
    while (k + 1 < shares_.size() && u >= shares_[k]) u -= shares_[k++];
    return k;
  }

  // Where it stands; the shares are those that it was made with.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(place_);
  }

 private:
  std::vector<double> shares_;
  std::uint64_t place_;
};

template <class Space, class SmallStep, class Estimator>
class MmltChains : public SeededChains<Space, LengthSeeds> {
 public:
  using W = typename Space::Universe;
  using Kernel = PrimaryKernel<SmallStep>;
  using Chain = MultiplexedChain<Space, SmallStep>;
  using Turns = LengthSequence;
  static constexpr Deposits deposits = Deposits::light;
  static constexpr bool has_comparable_chains = false;  // each has a length of its own

  MmltChains(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int,
             const FilmLayout& layout = {})
      : SeededChains<Space, LengthSeeds>(space, seed, group, space.max_vertices() - 1, layout),
        kernel_(kernel),
        numbers_(seed, group, chains()) {}

  static constexpr std::span<const std::string_view> move_names() { return primary_move_names; }
  bool takes_steps() const { return slice_.found_light() || !Estimator::needs_seed; }
  int chains() const { return space_.max_vertices() - 1; }
  void keep_chains(int) {}  // it has one for each length
  void start_chains(const SeedTally& others) {
    shares_ = shares_of_steps(others);
    for (int n = 2; n <= space_.max_vertices(); ++n)
      lengths_.push_back({{this->seed_tally().mean(n), others.mean(n), kernel_.large_step},
                          1 / shares_[static_cast<std::size_t>(n) - 2]});
  }

  static std::size_t stratum(int k) { return static_cast<std::size_t>(k); }
  bool has_seed(int k) const { return slice_.seed(k).weight > 0; }
  // Of paths of k + 2 vertices, as it starts.
  RunningChain<Chain> chain(int k) {
    Chain chain(space_, kernel_, k + 2);
    if (has_seed(k)) chain.start(slice_, slice_.seed(k), numbers_.place(k));
    return {std::move(chain), numbers_.chain(k)};
  }
  Turns turns() const { return Turns(shares_, numbers_.first_length()); }

  // ---- for those who watch

  template <class Put>
  void for_each_deposit(int k, const PrimaryStep<MultiplexedPath<W>>& step, const Features&,
                        Put&& put) const {
    const Length& length = lengths_[static_cast<std::size_t>(k)];
    PrimaryDeposit weights = Estimator::deposit(step, length.constants);
    weights.current *= length.scale;
    weights.proposed *= length.scale;
    wander::for_each_deposit(step, weights, put);
  }
  Observation observation(const PrimaryStep<MultiplexedPath<W>>& step,
                          const Features& current) const {
    return primary_observation(step, current, features_of(step.proposed));
  }
  Features features_of(const MultiplexedPath<W>& sample) const {
    return sample.total > 0 ? features(space_, sample.path) : Features{};
  }
  double ratio(const MultiplexedPath<W>& sample) const {
    return sample.total / technique_count(space_, sample.path.size());
  }

 private:
  using Base = SeededChains<Space, LengthSeeds>;
  using Base::slice_;
  using Base::space_;

  struct Length {
    PrimaryConstants constants;  // b_{g,n}
    double scale;                // 1 / q_n
  };

  Kernel kernel_;
  LengthNumbers numbers_;
  std::vector<double> shares_;   // q_n at n - 2
  std::vector<Length> lengths_;  // of n vertices at n - 2
};

template <class Space, class SmallStep, class Estimator>
using MmltGroup = ChainGroup<MmltChains<Space, SmallStep, Estimator>>;

}  // namespace wander
