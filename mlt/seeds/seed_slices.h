// The slices of the seed pass, one for each group of chains, where chains are taken out one by one:
// as many samples as render() makes when its budget asks for no more than `fewest_seeds`.
#pragma once

#include <memory>
#include <vector>

#include "mlt/run/chain_settings.h"
#include "mlt/seeds/nothing_found.h"
#include "mlt/seeds/seed_pass.h"
#include "work/parallel.h"

namespace wander {

template <class Space, class Seeds>
class SeedSlices {
 public:
  using Slice = SeedSlice<Space, Seeds>;

  // Makes the seed pass, with so many seeds of each slice.  Throws NoLightFound or NothingComputed.
  SeedSlices(const Space& space, Run& run, const ChainSettings& settings, int seeds)
      : max_vertices_(space.max_vertices()), tally_(max_vertices_) {
    for (int g = 0; g < settings.groups; ++g)
      slices_.push_back(std::make_unique<Slice>(space, run.session().seed, g, seeds));
    sample(run, settings.fewest_seeds / static_cast<std::uint64_t>(settings.groups));
    for (const auto& slice : slices_) tally_.merge(slice->tally());
    if (!(tally_.total.value() > 0)) throw NoLightFound(tally_.samples);
  }

  int count() const { return static_cast<int>(slices_.size()); }
  Slice& operator[](int group) const { return *slices_[static_cast<std::size_t>(group)]; }
  const SeedTally& tally() const { return tally_; }
  // What all groups but one found.
  SeedTally others(int group) const {
    SeedTally others(max_vertices_);
    for (int g = 0; g < count(); ++g)
      if (g != group) others.merge((*this)[g].tally());
    return others;
  }

 private:
  static constexpr std::uint64_t seeds_per_round = 64;

  void sample(Run& run, std::uint64_t per_slice) {
    for (std::uint64_t done = 0; done < per_slice;) {
      if (run.is_interrupted()) throw NothingComputed();
      const std::uint64_t samples = std::min(seeds_per_round, per_slice - done);
      run_parallel(run, count(), [&](int g) { (*this)[g].run(samples); });
      done += samples;
      run.report({static_cast<double>(done) / static_cast<double>(per_slice),
                  done * static_cast<std::uint64_t>(count()), run.seconds(), "seed pass"});
    }
  }

  int max_vertices_;
  std::vector<std::unique_ptr<Slice>> slices_;
  SeedTally tally_;
};

}  // namespace wander
