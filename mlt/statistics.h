// What the mutations did: an observer of steps, one per group of chains, merged in order.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/rendering.h"
#include "core/sum.h"
#include "mlt/chain.h"

namespace wander {

class MutationStatistics {
 public:
  static constexpr int no_bin = -1;

  MutationStatistics(std::span<const std::string_view> names, int bins);

  // `bin`: where the current path meets the film.
  template <class W>
  void observe(const Step<W>& step, int bin) {
    observe(step.mutation, step.reason, step.acceptance, bin);
  }
  // The same of a chain whose state is no path; in a state without light the bin is `no_bin`.
  void observe(int mutation, Reason reason, double acceptance, int bin) {
    Tally& tally = tallies_[static_cast<std::size_t>(mutation)];
    ++tally.proposed;
    ++tally.reasons[static_cast<std::size_t>(reason)];
    tally.acceptance += acceptance;
    if (bin == no_bin) return;
    tally.proposed_per_bin[static_cast<std::size_t>(bin)] += 1;
    tally.acceptance_per_bin[static_cast<std::size_t>(bin)] += acceptance;
  }

  void merge(const MutationStatistics& other);
  std::vector<MutationRecord> records() const;
  std::uint64_t steps() const;

 private:
  struct Tally {
    std::string_view name;
    std::uint64_t proposed = 0;
    std::array<std::uint64_t, reason_names.size()> reasons{};
    Sum acceptance;
    std::vector<double> proposed_per_bin, acceptance_per_bin;
  };
  std::vector<Tally> tallies_;
};

}  // namespace wander
