#include "mlt/statistics.h"

namespace wander {

MutationStatistics::MutationStatistics(std::span<const std::string_view> names, int bins) {
  for (const std::string_view name : names) {
    Tally& tally = tallies_.emplace_back();
    tally.name = name;
    tally.proposed_per_bin.resize(static_cast<std::size_t>(bins));
    tally.acceptance_per_bin.resize(static_cast<std::size_t>(bins));
  }
}

void MutationStatistics::merge(const MutationStatistics& other) {
  for (std::size_t m = 0; m < tallies_.size(); ++m) {
    Tally& mine = tallies_[m];
    const Tally& theirs = other.tallies_[m];
    mine.proposed += theirs.proposed;
    mine.acceptance += theirs.acceptance;
    for (std::size_t r = 0; r < mine.reasons.size(); ++r) mine.reasons[r] += theirs.reasons[r];
    for (std::size_t b = 0; b < mine.proposed_per_bin.size(); ++b) {
      mine.proposed_per_bin[b] += theirs.proposed_per_bin[b];
      mine.acceptance_per_bin[b] += theirs.acceptance_per_bin[b];
    }
  }
}

std::uint64_t MutationStatistics::steps() const {
  std::uint64_t steps = 0;
  for (const Tally& tally : tallies_) steps += tally.proposed;
  return steps;
}

std::vector<MutationRecord> MutationStatistics::records() const {
  std::vector<MutationRecord> records;
  for (const Tally& tally : tallies_) {
    if (tally.proposed == 0) continue;
    MutationRecord& record = records.emplace_back();
    record.name = tally.name;
    record.proposed = tally.proposed;
    record.accepted = tally.reasons[static_cast<std::size_t>(Reason::none)];
    record.mean_acceptance = tally.acceptance.value() / static_cast<double>(tally.proposed);
    for (std::size_t r = 1; r < tally.reasons.size(); ++r)
      if (tally.reasons[r] > 0) record.failures[std::string(reason_names[r])] = tally.reasons[r];
    record.proposed_per_bin = tally.proposed_per_bin;
    record.acceptance_per_bin = tally.acceptance_per_bin;
    for (std::size_t b = 0; b < record.acceptance_per_bin.size(); ++b)
      if (record.proposed_per_bin[b] > 0)
        record.acceptance_per_bin[b] /= record.proposed_per_bin[b];
  }
  return records;
}

}  // namespace wander
