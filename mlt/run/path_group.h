// Chains in path space: expected values of steps of one kernel, scaled by b_g.
#pragma once

#include "mlt/chain.h"
#include "mlt/run/group.h"

namespace wander {

template <class Space, class K>
class PathChains : public SeededChains<Space, PathSeeds> {
 public:
  using W = typename Space::Universe;
  using Kernel = K;
  using Chain = wander::Chain<Space, Kernel>;
  using Turns = EvenTurns;
  static constexpr Deposits deposits = Deposits::shares;
  static constexpr bool has_comparable_chains = true;
  static constexpr bool may_have_even_target = true;

  PathChains(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains,
             const FilmLayout& layout = {})
      : SeededChains<Space, PathSeeds>(space, seed, group, chains, layout),
        kernel_(kernel),
        first_chain_(group * chains),
        chain_count_(chains) {}

  static constexpr std::span<const std::string_view> move_names() { return Kernel::names; }
  bool takes_steps() const { return slice_.found_light(); }
  int chains() const { return chain_count_; }
  void keep_chains(int most) { chain_count_ = std::min(chain_count_, most); }
  void start_chains(const SeedTally& others) { kernel_.learn(others); }

  static std::size_t stratum(int) { return 0; }
  bool has_seed(int) const { return slice_.found_light(); }
  // As it starts.
  RunningChain<Chain> chain(int k) {
    return {Chain(space_, kernel_, slice_.replay(slice_.seed(k), space_.max_vertices())),
            Rng(seed_, Purpose::chain, static_cast<std::uint32_t>(first_chain_ + k))};
  }
  Turns turns() const { return Turns(chain_count_); }

  // ---- for those who watch

  template <class Put>
  void for_each_deposit(int, const Step<W>& step, const Features& current, Put&& put) const {
    wander::for_each_deposit(space_, step, current.bin, put);
  }
  Observation observation(const Step<W>& step, const Features& current) const {
    return wander::observation(space_, step, current);
  }
  Features features_of(const Path<W>& x) const { return features(space_, x); }
  double ratio(const Path<W>& x) const {
    return (x.contribution / x.intensity_under_roulette).value();
  }
  Functionals functionals_of(const Path<W>& x) const { return functionals(space_, x); }

 private:
  using Base = SeededChains<Space, PathSeeds>;
  using Base::seed_;
  using Base::slice_;
  using Base::space_;

  Kernel kernel_;
  int first_chain_, chain_count_;
};

template <class Space, class Kernel>
using PathGroup = ChainGroup<PathChains<Space, Kernel>>;

}  // namespace wander
