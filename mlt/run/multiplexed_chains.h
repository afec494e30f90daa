// The chains of an MMLT run, taken out one by one, as those who watch paths see them: each is the
// chain of one length in one group that render() makes with the same scene and seed, from its first
// path to its last random number, under the conditions of seeded_chains.h.  Which steps render()
// gives to which length does not matter to a chain.
//
// Lengths share the chains in proportion to their light: chain k goes to the length n of the
// largest b_n / (2 c_n + 1), where c_n chains went before [Sainte-Laguë 1910], and there to the
// next group that has a seed of n vertices.  A length whose groups are used up takes no more.
#pragma once

#include <string>

#include "mlt/primary/multiplexed_chain.h"
#include "mlt/seeds/seed_slices.h"

namespace wander {

template <class Space, class SmallStep>
class MultiplexedChains {
 public:
  using W = typename Space::Universe;
  using Kernel = PrimaryKernel<SmallStep>;
  static constexpr std::span<const std::string_view> names = primary_move_names;

  // Makes the seed pass.  Throws NoLightFound or NothingComputed.
  MultiplexedChains(const Space& space, const Kernel& kernel, Run& run, ChainSettings settings)
      : space_(space),
        kernel_(kernel),
        seed_(run.session().seed),
        slices_(space, run, settings, space.max_vertices() - 1) {
    share_chains();
  }

  const SeedTally& tally() const { return slices_.tally(); }
  int count() const { return static_cast<int>(places_.size()); }

  // A chain that shows its steps as steps of paths.
  class PathChain {
   public:
    explicit PathChain(MultiplexedChain<Space, SmallStep> chain) : chain_(std::move(chain)) {}

    template <class Random, class Observer>
    void step(Random& random, Observer&& observe) {
      chain_.step(random,
                  [&](const PrimaryStep<MultiplexedPath<W>>& step) { observe(path_step(step)); });
    }

    template <class OtherSpace, class Random>
    bool propose_again(const OtherSpace& space, Path<W>&, Random&) const {
      return chain_.propose_again(space);
    }

   private:
    MultiplexedChain<Space, SmallStep> chain_;
  };

  PathChain chain(int k) const {
    const auto [group, length] = place_of(k);
    MultiplexedChain<Space, SmallStep> chain(space_, kernel_, length + 2);
    chain.start(slices_[group], slices_[group].seed(length), numbers(group).place(length));
    return PathChain(std::move(chain));
  }
  Rng random(int k) const {
    const auto [group, length] = place_of(k);
    return numbers(group).chain(length);
  }

 private:
  struct Place {
    int group, length;  // n - 2
  };

  LengthNumbers numbers(int group) const { return {seed_, group, space_.max_vertices() - 1}; }
  const Place& place_of(int k) const {
    if (k >= count())
      throw std::runtime_error("chain " + std::to_string(k) +
                               " cannot start: each group has one chain of each length of which it "
                               "found light, which makes the chains 0 to " +
                               std::to_string(count() - 1));
    return places_[static_cast<std::size_t>(k)];
  }

  void share_chains() {
    std::vector<std::vector<int>> groups(tally().sum.size());  // with a seed, by length
    std::size_t chains = 0;
    for (int g = 0; g < slices_.count(); ++g)
      for (std::size_t n = 0; n < groups.size(); ++n) {
        if (!(slices_[g].seed(static_cast<int>(n)).weight > 0)) continue;
        groups[n].push_back(g);
        ++chains;
      }
    std::vector<std::size_t> taken(groups.size());
    while (places_.size() < chains) {
      const std::size_t n = next_length(groups, taken);
      places_.push_back({groups[n][taken[n]++], static_cast<int>(n)});
    }
  }
  std::size_t next_length(const std::vector<std::vector<int>>& groups,
                          const std::vector<std::size_t>& taken) const {
    std::size_t best = 0;
    double most = 0;
    for (std::size_t n = 0; n < groups.size(); ++n) {
      const double claim = tally().sum[n].value() / static_cast<double>(2 * taken[n] + 1);
      if (taken[n] == groups[n].size() || claim <= most) continue;
      most = claim;
      best = n;
    }
    return best;
  }

  const Space& space_;
  Kernel kernel_;
  std::uint64_t seed_;
  SeedSlices<Space, LengthSeeds> slices_;
  std::vector<Place> places_;  // of each chain
};

}  // namespace wander
