#include "mlt/watch/place_tallies.h"

#include <algorithm>

namespace wander {

PlaceTallies::PlaceTallies(const Raster& places, std::size_t mutations)
    : places_(places), mutations_(mutations) {
  if (entries() <= most_listed) table_.resize(entries());
}

void PlaceTallies::expect(std::uint64_t proposals) {
  if (!has_places() || !table_.empty()) return;
  list_.reserve(std::min<std::size_t>(list_.size() + proposals, most_listed));
  if (list_.size() + proposals > most_listed) table_.reserve(entries());
}

void PlaceTallies::make_table() {
  table_.resize(entries());
  for (const Proposal& made : list_) add(made);
  list_.clear();
}

void PlaceTallies::merge(const PlaceTallies& other) {
  if (!has_places()) return;
  if (table_.empty()) make_table();
  for (const Proposal& made : other.list_) add(made);
  for (std::size_t k = 0; k < other.table_.size(); ++k) {
    table_[k].proposed += other.table_[k].proposed;
    table_[k].acceptance += other.table_[k].acceptance;
  }
}

std::vector<PlaceTallies::Tally> PlaceTallies::of_mutation(std::size_t mutation) const {
  std::vector<Tally> tallies(places_.cells());
  if (!table_.empty())
    for (std::size_t k = 0; k < tallies.size(); ++k) tallies[k] = table_[k * mutations_ + mutation];
  for (const Proposal& made : list_)
    if (made.entry % mutations_ == mutation) {
      Tally& tally = tallies[made.entry / mutations_];
      tally.proposed += 1;
      tally.acceptance += made.acceptance;
    }
  return tallies;
}

}  // namespace wander
