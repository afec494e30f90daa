// A group of chains: its slice of the seed pass, its chains, and what they deposit.  Groups share
// nothing; they are the unit of parallel work, and their spread is the error bar.
//
// The constants of a group are those of its own slice: seeds and constants from one slice make the
// film unbiased for chains of any length (seed_pass.h).  How much a group does must not depend on
// that slice, or the product of the two is biased.
//
// A group is a value that goes on: serialize_seeds(archive), and once its chains have started
// serialize_chains(archive), are its whole state.
#pragma once

#include <concepts>

#include "mlt/run/deposit.h"
#include "mlt/run/group_findings.h"
#include "mlt/watch/functionals.h"
#include "mlt/watch/statistics.h"

namespace wander {

template <class G>
concept Group = requires(G& group, const G& made, std::uint64_t count, const SeedTally& others,
                         GroupsFilm& film, MutationStatistics& statistics, ChainDraws& draws) {
  group.add_seeds(count);
  { made.tally() } -> std::same_as<const SeedTally&>;
  // After the seed pass: of the chains for which there are seeds, only so many run.
  group.keep_chains(1);
  // After that; `others`: what all other groups found.
  group.start_chains(others);
  // Can steps add anything to the film?
  { made.takes_steps() } -> std::same_as<bool>;
  group.advance(count);  // makes so many more steps, of all chains together
  { made.steps() } -> std::same_as<std::uint64_t>;
  { made.chains() } -> std::same_as<int>;
  made.deliver(film, statistics, draws);
  { made.findings() } -> std::same_as<GroupFindings>;
  G::move_names();  // of what its statistics count
};

// What all groups have in common.
template <class Space, class Seeds>
class SeededGroup {
 public:
  void add_seeds(std::uint64_t count) { slice_.run(count); }
  const SeedTally& tally() const { return slice_.tally(); }
  std::uint64_t steps() const { return steps_; }

  // Between two samples of the seed pass, or after it.
  template <class Archive>
  void serialize_seeds(Archive& archive) {
    archive(slice_);
  }

 protected:
  SeededGroup(const Space& space, std::uint64_t seed, int group, int seeds,
              std::span<const std::string_view> moves)
      : space_(space),
        slice_(space, seed, group, seeds),
        film_(space.scene().bins(), space.max_vertices()),
        states_(slice_.evidence().ratios.size()),
        statistics_(moves, space.scene().bins(), space.max_vertices()) {}

  // Between two steps.  What follows from the slices is left out: start_chains() makes it again.
  template <class Archive>
  void serialize_steps(Archive& archive) {
    archive(steps_, film_, states_, statistics_);
  }

  // Before the first step: keep_state() does not allocate.
  void expect_states() {
    constexpr int octaves = 24;  // beyond which a state tells the bridge nothing new
    for (std::size_t k = 0; k < states_.size(); ++k)
      states_[k].make_room(slice_.evidence().ratios[k], octaves);
  }
  // The state of a chain after each step: its f / p̄.
  void keep_state(std::size_t stratum, double ratio) { states_[stratum].add_within(ratio); }

  // All but the classes.  `scale` is that of the film; light(k) what the slice found in stratum k,
  // which all states of that stratum together stand for.
  template <class Light>
  GroupFindings findings_of(double scale, Light&& light) const {
    GroupFindings found{&slice_.tally(), &slice_.evidence(), &film_, scale};
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const double count = states_[k].count();
      found.states.push_back({&states_[k], count > 0 ? light(k) / count : 0});
    }
    return found;
  }

  // step(k) for chain k, so often that the steps are shared evenly by `chains` of them.
  template <class Step>
  void share_evenly(std::uint64_t steps, std::uint64_t chains, Step&& step) {
    const std::uint64_t target = steps_ + steps;
    const auto share = [chains](std::uint64_t total, std::uint64_t k) {
      return total / chains + (k < total % chains ? 1 : 0);
    };
    for (std::uint64_t k = 0; k < chains; ++k)
      for (std::uint64_t i = share(steps_, k); i < share(target, k); ++i) step(k);
    steps_ = target;
  }

  const Space& space_;
  SeedSlice<Space, Seeds> slice_;
  GroupFilm film_;
  std::vector<RatioHistogram> states_;  // by stratum
  MutationStatistics statistics_;
  std::uint64_t steps_ = 0;
};

}  // namespace wander
