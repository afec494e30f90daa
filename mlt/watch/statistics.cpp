#include "mlt/watch/statistics.h"

#include <numeric>
#include <tuple>

namespace wander {

MutationStatistics::MutationStatistics(std::span<const std::string_view> names,
                                       const Raster& places, int max_vertices)
    : places_(places, names.size()),
      lengths_(static_cast<std::size_t>(std::min(max_vertices, most_vertices)) - 1),
      by_length_(lengths_ * names.size()),
      by_class_(room_for_classes<Outcomes>(names.size())),
      groups_of_class_(ClassTable::most_classes + 1) {
  for (const std::string_view name : names) tallies_.emplace_back().name = name;
}

void MutationStatistics::Outcomes::merge(const Outcomes& other) {
  for (std::size_t r = 0; r < reasons.size(); ++r) reasons[r] += other.reasons[r];
  acceptance += other.acceptance;
}

std::uint64_t MutationStatistics::Outcomes::proposed() const {
  return std::accumulate(reasons.begin(), reasons.end(), std::uint64_t{0});
}

PathsRecord MutationStatistics::Outcomes::record() const {
  PathsRecord record;
  record.proposed = proposed();
  record.accepted = reasons[static_cast<std::size_t>(Reason::none)];
  record.mean_acceptance = acceptance.value() / static_cast<double>(record.proposed);
  for (std::size_t r = 1; r < reasons.size(); ++r)
    if (reasons[r] > 0) record.failures[std::string(reason_names[r])] = reasons[r];
  return record;
}

MutationStatistics::Outcomes MutationStatistics::total(std::size_t mutation) const {
  Outcomes sum;
  for (std::size_t k = mutation; k < by_length_.size(); k += tallies_.size())
    sum.merge(by_length_[k]);
  return sum;
}

// `other` is of one group.
void MutationStatistics::merge(const MutationStatistics& other) {
  for (std::size_t m = 0; m < tallies_.size(); ++m) {
    Tally& mine = tallies_[m];
    const Tally& theirs = other.tallies_[m];
    mine.squared_jump += theirs.squared_jump;
    mine.longest_run = std::max(mine.longest_run, theirs.longest_run);
    mine.measured_seconds += theirs.measured_seconds;
    mine.measured += theirs.measured;
  }
  places_.merge(other.places_);
  for (std::size_t k = 0; k < by_length_.size(); ++k) by_length_[k].merge(other.by_length_[k]);
  for (const Visits& theirs : other.visits()) ++groups_of_class_[classes_.index(theirs.path_class)];
  for (std::size_t c = 0; c < other.classes_.size(); ++c)
    for (std::size_t m = 0; m < tallies_.size(); ++m)
      by_class(classes_.index(other.classes_.code(c)), m)
          .merge(other.by_class_[c * tallies_.size() + m]);
  longest_run_ = std::max(longest_run_, other.longest_run_);
}

std::uint64_t MutationStatistics::steps() const {
  std::uint64_t steps = 0;
  for (const Outcomes& outcomes : by_length_) steps += outcomes.proposed();
  return steps;
}

std::uint64_t MutationStatistics::steps(Reason reason) const {
  std::uint64_t steps = 0;
  for (const Outcomes& outcomes : by_length_)
    steps += outcomes.reasons[static_cast<std::size_t>(reason)];
  return steps;
}

std::vector<MutationStatistics::Visits> MutationStatistics::visits() const {
  std::vector<Visits> visits;
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    Visits of_class{classes_.code(c), 0, groups_of_class_[c]};
    for (std::size_t m = 0; m < tallies_.size(); ++m)
      of_class.steps += by_class_[c * tallies_.size() + m].proposed();
    if (of_class.steps > 0) visits.push_back(of_class);
  }
  return visits;
}

std::vector<PathsRecord> MutationStatistics::records_by_length(std::size_t mutation) const {
  std::vector<PathsRecord> records;
  for (std::size_t k = 0; k < lengths_; ++k) {
    const Outcomes& outcomes = by_length_[k * tallies_.size() + mutation];
    if (outcomes.proposed() == 0) continue;
    records.push_back(outcomes.record());
    records.back().vertices = static_cast<int>(k) + 2;
  }
  return records;
}

// Short paths first, then in the order of the alphabet; `other` is the last.
std::vector<PathsRecord> MutationStatistics::records_by_class(std::size_t mutation) const {
  std::vector<PathsRecord> records;
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const Outcomes& outcomes = by_class_[c * tallies_.size() + mutation];
    if (outcomes.proposed() == 0) continue;
    records.push_back(outcomes.record());
    records.back().path_class = name_of_class(classes_.code(c));
  }
  std::ranges::sort(records, {}, [](const PathsRecord& r) {
    const bool other = r.path_class == name_of_class(other_class);
    return std::tuple(other, r.path_class.size(), r.path_class);
  });
  return records;
}

MutationRecord MutationStatistics::record(std::size_t mutation) const {
  const Tally& tally = tallies_[mutation];
  const PathsRecord all = total(mutation).record();
  MutationRecord record;
  record.name = tally.name;
  record.proposed = all.proposed;
  record.accepted = all.accepted;
  record.mean_acceptance = all.mean_acceptance;
  record.failures = all.failures;
  for (const auto& [proposed, acceptance] : places_.of_mutation(mutation)) {
    record.proposed_per_bin.push_back(proposed);
    record.acceptance_per_bin.push_back(proposed > 0 ? acceptance / proposed : 0);
  }
  if (tally.measured > 0)
    record.seconds = tally.measured_seconds / static_cast<double>(tally.measured) *
                     static_cast<double>(all.proposed);
  record.squared_jump = tally.squared_jump.value() / static_cast<double>(all.proposed);
  record.longest_rejection_run = tally.longest_run;
  record.by_length = records_by_length(mutation);
  record.by_class = records_by_class(mutation);
  return record;
}

std::vector<MutationRecord> MutationStatistics::records() const {
  std::vector<MutationRecord> records;
  for (std::size_t m = 0; m < tallies_.size(); ++m)
    if (total(m).proposed() > 0) records.push_back(record(m));
  return records;
}

}  // namespace wander
