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
  MutationStatistics(std::span<const std::string_view> names, int bins);

  // `bin`: where the current path meets the film.
  template <class W>
  void observe(const Step<W>& step, int bin) {
    Tally& tally = tallies_[static_cast<std::size_t>(step.mutation)];
    const auto b = static_cast<std::size_t>(bin);
    ++tally.proposed;
    ++tally.reasons[static_cast<std::size_t>(step.reason)];
    tally.acceptance += step.acceptance;
    tally.proposed_per_bin[b] += 1;
    tally.acceptance_per_bin[b] += step.acceptance;
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
