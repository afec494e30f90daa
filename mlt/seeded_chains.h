// The chains of a run, taken out one by one: each is the chain that render() makes of the same
// scene, mixture and seed, from its first path to its last random number, as long as the budget of
// render() is enough for all its chains and asks for no more seeds than `fewest_seeds`.
//
// Chain k of L groups that found light is the chain k / L of the group k mod L: as many groups as
// possible are drawn on, for chains of one group share their slice of the seed pass.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "mlt/render.h"

namespace wander {

// The run was interrupted before there was anything to keep.
class NothingComputed : public std::runtime_error {
 public:
  NothingComputed() : std::runtime_error("interrupted before the first step") {}
};

template <class Space, class Kernel>
class SeededChains {
 public:
  using W = typename Space::Universe;

  // Makes the seed pass.  Throws NoLightFound or NothingComputed.
  SeededChains(const Space& space, const Kernel& kernel, Run& run, ChainSettings settings)
      : space_(space), run_(run), settings_(settings), tally_(space.max_vertices()) {
    for (int g = 0; g < settings.groups; ++g)
      slices_.push_back(
          std::make_unique<Slice>(space, run.session().seed, g, settings.chains_per_group));
    seed_pass();
    for (int g = 0; g < settings.groups; ++g) {
      tally_.merge(slice(g).tally());
      if (slice(g).found_light()) lit_.push_back(g);
    }
    if (lit_.empty()) throw NoLightFound(tally_.samples);
    for (int g = 0; g < settings.groups; ++g) kernels_.push_back(taught(kernel, g));
  }

  const SeedTally& tally() const { return tally_; }
  int count() const { return static_cast<int>(lit_.size()) * settings_.chains_per_group; }

  Chain<Space, Kernel> chain(int k) const {
    const Place place = place_of(k);
    Slice& slice = this->slice(place.group);
    const Kernel& kernel = kernels_[static_cast<std::size_t>(place.group)];
    return {space_, kernel, slice.replay(slice.seed(place.member), space_.max_vertices())};
  }
  Rng random(int k) const {
    const Place place = place_of(k);
    const int stream = place.group * settings_.chains_per_group + place.member;
    return {run_.session().seed, Purpose::chain, static_cast<std::uint32_t>(stream)};
  }

 private:
  using Slice = SeedSlice<Space>;
  static constexpr std::uint64_t seeds_per_round = 64;

  struct Place {
    int group, member;
  };
  Place place_of(int k) const {
    if (k >= count())
      throw std::runtime_error(
          "chain " + std::to_string(k) + " cannot start: the seed pass found light in " +
          std::to_string(lit_.size()) + " of " + std::to_string(settings_.groups) +
          " groups, which is enough for the chains 0 to " + std::to_string(count() - 1));
    const auto lit = static_cast<int>(lit_.size());
    return {lit_[static_cast<std::size_t>(k % lit)], k / lit};
  }
  // The kernel of a group's chains: it has learned from the seeds of all others.
  Kernel taught(Kernel kernel, int group) const {
    SeedTally others(space_.max_vertices());
    for (int g = 0; g < settings_.groups; ++g)
      if (g != group) others.merge(slice(g).tally());
    kernel.learn(others);
    return kernel;
  }
  Slice& slice(int g) const { return *slices_[static_cast<std::size_t>(g)]; }

  void seed_pass() {
    const auto groups = static_cast<std::uint64_t>(settings_.groups);
    const std::uint64_t per_group = settings_.fewest_seeds / groups;
    for (std::uint64_t done = 0; done < per_group;) {
      if (run_.is_interrupted()) throw NothingComputed();
      const std::uint64_t count = std::min(seeds_per_round, per_group - done);
      run_parallel(run_, settings_.groups, [&](int g) { slice(g).run(count); });
      done += count;
      run_.report({static_cast<double>(done) / static_cast<double>(per_group), done * groups,
                   run_.seconds(), "seed pass"});
    }
  }

  const Space& space_;
  Run& run_;
  ChainSettings settings_;
  std::vector<std::unique_ptr<Slice>> slices_;
  SeedTally tally_;
  std::vector<int> lit_;         // groups
  std::vector<Kernel> kernels_;  // by group
};

}  // namespace wander
