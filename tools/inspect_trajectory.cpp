#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "lab/wording.h"
#include "records/run_json.h"
#include "tools/console.h"
#include "tools/inspection.h"
#include "tools/summary.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

// What the recorded steps say of each mutation.
std::vector<MutationRecord> mutations_of(const Trajectory& t) {
  std::vector<MutationRecord> mutations(t.mutations.size());
  for (std::size_t m = 0; m < mutations.size(); ++m) mutations[m].name = t.mutations[m];
  for (std::size_t i = 0; i < t.size(); ++i) {
    MutationRecord& mutation = mutations[static_cast<std::size_t>(t.mutation[i])];
    ++mutation.proposed;
    mutation.mean_acceptance += t.acceptance[i];
    if (t.accepted[i])
      ++mutation.accepted;
    else
      ++mutation.failures[t.reasons[static_cast<std::size_t>(t.reason[i])]];
  }
  std::erase_if(mutations, [](const MutationRecord& m) { return m.proposed == 0; });
  for (MutationRecord& m : mutations) m.mean_acceptance /= static_cast<double>(m.proposed);
  return mutations;
}

ordered_json json_of(const std::vector<MutationRecord>& mutations) {
  ordered_json json = ordered_json::object();
  for (const MutationRecord& m : mutations)
    json[m.name] = {{"proposed", m.proposed},
                    {"accepted", m.accepted},
                    {"mean_acceptance", m.mean_acceptance},
                    {"failures", m.failures}};
  return json;
}

// How often each word was recorded, the commonest first.
using Counts = std::vector<std::pair<std::string, std::uint64_t>>;
Counts counts(const std::vector<std::string>& words, const std::vector<std::int32_t>& indices) {
  Counts counts;
  for (const std::string& word : words) counts.emplace_back(word, 0);
  for (const std::int32_t index : indices)
    if (index >= 0) ++counts[static_cast<std::size_t>(index)].second;
  std::erase_if(counts, [](const auto& count) { return count.second == 0; });
  std::ranges::stable_sort(counts, std::ranges::greater{}, &Counts::value_type::second);
  return counts;
}

ordered_json json_of(const Counts& counts) {
  ordered_json json = ordered_json::object();
  for (const auto& [word, count] : counts) json[word] = count;
  return json;
}

std::string shares(const Counts& counts, std::size_t size, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(counts.size(), most); ++i)
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", counts[i].first,
                        percent(static_cast<double>(counts[i].second) / static_cast<double>(size)));
  return counts.size() > most ? text + fmt::format(" and {} more", counts.size() - most) : text;
}

}  // namespace

ordered_json inspect_trajectory(const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  return {
      {"schema", "wanderlight-inspection/1"},
      {"kind", "trajectory"},
      {"complete", record.complete},
      {"scene",
       {{"name", record.provenance.scene_name}, {"sha256", record.provenance.scene_digest.text}}},
      {"dimension", t.dimension},
      {"method", record.method},
      {"chains", t.chains},
      {"draws", t.draws},
      {"first_step", t.first_step},
      {"every", t.every},
      {"seed", record.seed},
      {"normalization",
       {{"value", finite_or_null(record.normalization.value)},
        {"standard_error", finite_or_null(record.normalization.standard_error)}}},
      {"mutations", json_of(mutations_of(t))},
      {"reasons", json_of(counts(t.reasons, t.reason))},
      {"classes", json_of(counts(t.classes, t.state.path_class))},
      {"command_line", record.provenance.command_line},
      {"version", record.provenance.version},
      {"provenance", to_json(record.provenance.origin)}};
}

std::string text_of_trajectory(const TrajectoryRecord& record) {
  const Trajectory& t = record.trajectory;
  constexpr std::size_t most_words = 6;
  std::string text =
      fmt::format("{}: {} chain{} of {} draws, from step {}, every {}; seed {}{}\n", record.method,
                  t.chains, t.chains == 1 ? "" : "s", t.draws, t.first_step, t.every, record.seed,
                  record.complete ? "" : "; INCOMPLETE, it was interrupted");
  text += fmt::format("  normalization   {}\n", with_error(record.normalization));
  text += mutation_lines(mutations_of(t));
  text += fmt::format("  reasons         {}\n",
                      shares(counts(t.reasons, t.reason), t.size(), most_words));
  text += fmt::format("  classes         {}\n",
                      shares(counts(t.classes, t.state.path_class), t.size(), most_words));
  text += fmt::format("  scene           {}\n", record.provenance.scene_name.empty()
                                                    ? "without a name"
                                                    : record.provenance.scene_name);
  text += fmt::format("  scene sha256    {}\n", record.provenance.scene_digest.text);
  return text + made_by_lines(record.provenance);
}

}  // namespace wander
