// The chains of a run, taken out one by one: each is the chain that render() makes of the same
// scene, mixture and seed, from its first path to its last random number, as long as the budget of
// render() is enough for all its chains and asks for no more seeds than `fewest_seeds`.
//
// Chain k of L groups that found light is the chain k / L of the group k mod L: as many groups as
// possible are drawn on, for chains of one group share their slice of the seed pass.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "mlt/chain.h"
#include "mlt/seeds/seed_slices.h"

namespace wander {

template <class Space, class Kernel>
class SeededChains {
 public:
  using W = typename Space::Universe;
  static constexpr std::span<const std::string_view> names = Kernel::names;

  // Makes the seed pass.  Throws NoLightFound or NothingComputed.
  SeededChains(const Space& space, const Kernel& kernel, Run& run, ChainSettings settings)
      : space_(space),
        seed_(run.session().seed),
        chains_per_group_(settings.chains_per_group),
        slices_(space, run, settings, settings.chains_per_group) {
    for (int g = 0; g < slices_.count(); ++g) {
      if (slices_[g].found_light()) lit_.push_back(g);
      kernels_.push_back(kernel);  // of a group's chains: it learns from the seeds of all others
      kernels_.back().learn(slices_.others(g));
    }
  }

  const SeedTally& tally() const { return slices_.tally(); }
  int count() const { return static_cast<int>(lit_.size()) * chains_per_group_; }

  Chain<Space, Kernel> chain(int k) const {
    const auto [group, member] = place_of(k);
    auto& slice = slices_[group];
    const Kernel& kernel = kernels_[static_cast<std::size_t>(group)];
    return {space_, kernel, slice.replay(slice.seed(member), space_.max_vertices())};
  }
  Rng random(int k) const {
    const auto [group, member] = place_of(k);
    return {seed_, Purpose::chain, static_cast<std::uint32_t>(group * chains_per_group_ + member)};
  }

 private:
  struct Place {
    int group, member;
  };
  Place place_of(int k) const {
    if (k >= count())
      throw std::runtime_error(
          "chain " + std::to_string(k) + " cannot start: the seed pass found light in " +
          std::to_string(lit_.size()) + " of " + std::to_string(slices_.count()) +
          " groups, which is enough for the chains 0 to " + std::to_string(count() - 1));
    const auto lit = static_cast<int>(lit_.size());
    return {lit_[static_cast<std::size_t>(k % lit)], k / lit};
  }

  const Space& space_;
  std::uint64_t seed_;
  int chains_per_group_;
  SeedSlices<Space, PathSeeds> slices_;
  std::vector<int> lit_;         // groups
  std::vector<Kernel> kernels_;  // by group
};

}  // namespace wander
