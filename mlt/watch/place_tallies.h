// What was proposed, and how much of it accepted, by place on the film, of each of several mutations.
//
// A table has room for all places and mutations, in each group of chains; a run on a large film may
// meet few of them.  So where that is large the first proposals are a list, in their order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/raster.h"

namespace wander {

class PlaceTallies {
 public:
  struct Tally {
    double proposed = 0, acceptance = 0;  // sums

    template <class Archive>
    void serialize(Archive& archive) {
      archive(proposed, acceptance);
    }
  };

  // `places`: the cells that are told apart; there may be none.
  PlaceTallies(const Raster& places, std::size_t mutations);

  bool has_places() const { return places_.cells() > 0; }
  // So that the next proposals, this many, allocate nothing.
  void expect(std::uint64_t proposals);
  // Made while the path was in this bin of the film.
  void add(std::size_t mutation, int bin, double acceptance);
  void merge(const PlaceTallies& other);  // of the same places and mutations
  std::vector<Tally> of_mutation(std::size_t mutation) const;

  // Into one of the same places and mutations.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(list_, table_);
  }

 private:
  struct Proposal {
    std::uint32_t entry;  // of the table
    double acceptance;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(entry, acceptance);
    }
  };
  static constexpr std::size_t most_listed = 1 << 12;

  std::size_t entries() const { return places_.cells() * mutations_; }
  void add(const Proposal& made) {
    Tally& tally = table_[made.entry];
    tally.proposed += 1;
    tally.acceptance += made.acceptance;
  }
  void make_table();

  Raster places_;
  std::size_t mutations_;
  std::vector<Proposal> list_;  // until it is full
  std::vector<Tally> table_;    // then; mutations of a place side by side
};

inline void PlaceTallies::add(std::size_t mutation, int bin, double acceptance) {
  const std::size_t entry = places_.cell(bin) * mutations_ + mutation;
  const Proposal made{static_cast<std::uint32_t>(entry), acceptance};
  if (table_.empty() && list_.size() < most_listed) return list_.push_back(made);
  if (table_.empty()) make_table();
  add(made);
}

}  // namespace wander
