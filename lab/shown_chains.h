// The chains of a run, made one by one for those who show them: trace and replay.  They are the
// chains that render() makes of the same scene, method and seed for a film of the chains alone, with the target of light on
// an image, as long as its budget is enough for all of them and asks for no more seeds than `fewest_seeds`.  Nothing is deposited.
#pragma once

#include <string>
#include <vector>

#include "lab/live_run.h"
#include "mlt/run/chain_groups.h"
#include "mlt/seeds/nothing_found.h"

namespace wander {

struct ChainPlace {
  int group, chain;

  bool operator==(const ChainPlace&) const = default;
};

// Which chain is shown first, which second, and so on.  Chains come by stratum, in each in the order
// in which they are to be shown.  Strata share them in proportion to their light: the next is of
// the stratum of the largest light / (2 c + 1), where c of its chains went before [Sainte-Laguë
// 1910]; a stratum whose chains are used up takes no more.
std::vector<ChainPlace> order_of_chains(const std::vector<std::vector<ChainPlace>>& by_stratum,
                                        const std::vector<double>& light);

// `Chains` are the SeededChains of a method whose states are paths.
template <class Space, class Chains>
class ShownChains {
 public:
  using Chain = RunningChain<typename Chains::Chain>;

  // Makes the seed pass.  Throws NoLightFound or NothingComputed.
  template <class Kernel>
  ShownChains(const Space& space, const Kernel& kernel, Run& run, const ChainSettings& settings)
      : groups_(space, kernel, run, run.session().seed, settings), tally_(space.max_vertices()) {
    make_seeds(run, settings.fewest_seeds / groups_.count());
    tally_ = groups_.tally();
    if (!(tally_.total.value() > 0)) throw NoLightFound(tally_.samples);
    groups_.start(settings.chains_per_group);
    put_in_order();
  }

  const SeedTally& tally() const { return tally_; }
  int count() const { return static_cast<int>(places_.size()); }

  // As it starts.
  Chain chain(int k) const {
    if (k >= count())
      throw std::runtime_error("chain " + std::to_string(k) +
                               " cannot start: the seed pass found light for the chains 0 to " +
                               std::to_string(count() - 1) + " only");
    const ChainPlace& place = places_[static_cast<std::size_t>(k)];
    return groups_[place.group].chain(place.chain);
  }

 private:
  // In rounds as long as those of render(), and no more of them than that makes where samples are costly.
  void make_seeds(Run& run, std::uint64_t of_each) {
    for (std::uint64_t done = 0; done < of_each && !is_costly();) {
      if (run.is_interrupted()) throw NothingComputed();
      const std::uint64_t samples = std::min(groups_.seed_stride(), of_each - done);
      groups_.add_seeds(samples);
      done += samples;
      run.report({static_cast<double>(done) / static_cast<double>(of_each), done * groups_.count(),
                  run.seconds(), "seed pass"});
    }
  }

  bool is_costly() const {
    const SeedTally made = groups_.tally();
    return SeedPass{.slices = groups_.count(), .samples = made.samples, .rays = made.rays}
        .is_costly();
  }

  // The first chain of every group before the second of any: chains of one group share their slice
  // of the seed pass.
  void put_in_order() {
    std::vector<std::vector<ChainPlace>> by_stratum;
    for (int k = 0; k < groups_[0].chains(); ++k) {
      by_stratum.resize(std::max(by_stratum.size(), Chains::stratum(k) + 1));
      for (int g = 0; g < static_cast<int>(groups_.count()); ++g)
        if (groups_[g].has_seed(k)) by_stratum[Chains::stratum(k)].push_back({g, k});
    }
    std::vector<double> light;
    for (std::size_t s = 0; s < by_stratum.size(); ++s)
      light.push_back(Chains::Seeds::measure(tally_, s));
    places_ = order_of_chains(by_stratum, light);
  }

  ChainGroups<Space, Chains> groups_;
  SeedTally tally_;
  std::vector<ChainPlace> places_;
};

}  // namespace wander
