#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lab/compare/comparison_fields.h"
#include "lab/compare/comparison_json.h"
#include "lab/compare/film_files.h"
#include "records/exr.h"
#include "records/json_place.h"
#include "records/key_limit.h"
#include "records/pending_names.h"
#include "records/run_json.h"
#include "records/scene_record.h"
#include "records/temporary_file.h"

namespace wander::compare {

using nlohmann::ordered_json;

namespace {

void read(double& value, const JsonPlace& json) { value = json.number(); }

void read(Measured& measured, const JsonPlace& json) {
  read(measured.value, json.at("value"));
  read(measured.interval.low, json.at("low"));
  read(measured.interval.high, json.at("high"));
}

template <class Record, class Value, std::size_t n>
void read_fields(Record& record, const JsonPlace& json,
                 const std::array<Field<Record, Value>, n>& fields) {
  for (const auto& field : fields) read(record.*field.member, json.at(field.name));
}

void read(Contender& contender, const JsonPlace& json) {
  contender = {json.at("label"), json.at("method"), json.at("dial"), json.at("setting")};
}

void read(Cell& cell, const JsonPlace& json) {
  cell.contender = json.at("contender");
  cell.budget = json.at("budget");
  cell.replicates = json.at("replicates");
  read_fields(cell, json, cell_fields);
  read_fields(cell, json, cell_numbers);
}

void read(Curve& curve, const JsonPlace& json) {
  curve.contender = json.at("contender");
  curve.inverse_root = json.at("inverse_root");
  read_fields(curve, json, curve_fields);
}

void read(Crossing& crossing, const JsonPlace& json) {
  crossing.ahead = json.at("ahead");
  crossing.behind = json.at("behind");
  crossing.significant = json.at("significant");
  read(crossing.p_value, json.at("p_value"));
  read_fields(crossing, json, crossing_fields);
}

void read(std::vector<double>& values, const JsonPlace& json) { values = json.numbers(); }

void read(Profile& profile, const JsonPlace& json) {
  profile.contender = json.at("contender");
  read(profile.seconds, json.at("seconds"));
  read(profile.share, json.at("share"));
}

void read(Run& run, const JsonPlace& json) {
  run.contender = json.at("contender");
  run.budget = json.at("budget");
  run.replicate = json.at("replicate");
  run.seed = json.at("seed");
  run.samples = json.at("samples");
  read(run.seconds, json.at("seconds"));
  run.processor_seconds = json.number_if("cpu_seconds");
  read(run.seed_seconds, json.at("seed_seconds"));
  run.seed_samples = json.at("seed_samples");
  run.command = json.at("command");
  run.film = film_from_json(json.at("film"));
}

void read(FailedRun& run, const JsonPlace& json) {
  run.contender = json.at("contender");
  run.budget = json.at("budget");
  run.replicate = json.at("replicate");
  run.seed = json.at("seed");
  run.message = json.at("message");
}

template <class Record>
void read(std::vector<Record>& records, const JsonPlace& json) {
  for (const JsonPlace& entry : json.elements()) read(records.emplace_back(), entry);
}

Runs runs_from(const JsonPlace& json, const std::string& place) {
  Runs runs;
  Provenance& provenance = runs.provenance;
  read_scene(json.at("scene"), provenance);
  provenance.dimension = json.at("dimension");
  provenance.command_line = json.at("command_line").get<std::string>();
  provenance.version = json.at("version").get<std::string>();
  provenance.origin = origin_from_json(json);
  runs.complete = json.at("complete");
  runs.warnings = json.at("warnings").get<std::vector<std::string>>();
  read(runs.contenders, json.at("contenders"));
  runs.budgets = json.at("budgets").get<std::vector<std::string>>();
  runs.replicates = json.at("replicates");
  runs.time =
      json.value("time", std::string("wall")) == "cpu" ? TimeKind::processor : TimeKind::wall;
  runs.reference.origin = json.at("reference").at("origin");
  runs.reference.film = film_from_json(json.at("reference").at("film"));
  runs.reference.max_vertices = json.at("reference").value("max_vertices", 0);
  read(runs.runs, json.at("runs"));
  read(runs.failures, json.at("failures"));
  for (const JsonPlace& run : json.at("details").elements())
    runs.details.push_back(run_from_json(run, place).rendering);
  return runs;
}

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

// What is drawn from a comparison relies on its indices and sizes.
void require_consistent(const Comparison& c) {
  const std::size_t contenders = c.runs.contenders.size(), budgets = c.runs.budgets.size();
  const std::size_t bins = c.runs.reference.film.value.size();
  const auto known = [&](const auto& record) { return record.contender < contenders; };
  require(c.decisive < std::max(budgets, std::size_t{1}), "its decisive budget does not exist");
  require(c.cells.size() == contenders * budgets, "its cells are not one for each budget");
  for (std::size_t i = 0; i < c.cells.size(); ++i)
    require(c.cells[i].contender == i / budgets && c.cells[i].budget == i % budgets,
            "its cells are in another order");
  for (std::size_t i = 0; i < c.curves.size(); ++i)
    require(c.curves[i].contender == i, "its curves are in another order");
  require(c.curves.size() == (budgets > 0 ? contenders : 0), "its curves are not one each");
  require(std::ranges::all_of(c.profiles, known), "a profile is of an unknown contender");
  for (const Profile& profile : c.profiles)
    require(profile.seconds.size() == profile.share.size(), "a profile's lists differ in length");
  for (const Crossing& crossing : c.crossings)
    require(crossing.ahead < contenders && crossing.behind < contenders,
            "a crossing is of an unknown contender");
  std::vector<std::size_t> ranked = c.ranking;
  std::ranges::sort(ranked);
  require(ranked.size() == c.curves.size(), "its ranking does not name each contender once");
  for (std::size_t i = 0; i < ranked.size(); ++i)
    require(ranked[i] == i, "its ranking does not name each contender once");
  for (const Run& run : c.runs.runs)
    require(known(run) && run.budget < budgets, "a run is of an unknown contender or budget");
  require(std::ranges::all_of(c.runs.failures, known), "a failed run is of an unknown contender");
  for (const Run& run : c.runs.runs)
    require(run.film.value.size() == bins, "a film is not as large as the reference");
}

Comparison read_comparison(const JsonPlace& json, const std::string& place) {
  if (json.at("schema").get<std::string>() != comparison_schema)
    json.at("schema").refuse("its schema is another");
  Comparison comparison;
  comparison.runs = runs_from(json, place);
  for (const JsonPlace& run : json.at("runs").elements())
    read_fields(comparison.errors.emplace_back(), run.at("errors"), error_fields);
  read(comparison.target, json.at("target"));
  comparison.decisive = json.at("decisive_budget");
  read(comparison.cells, json.at("cells"));
  read(comparison.curves, json.at("curves"));
  read(comparison.crossings, json.at("crossings"));
  read(comparison.profiles, json.at("profiles"));
  comparison.ranking = json.at("ranking").get<std::vector<std::size_t>>();
  comparison.verdict = json.at("verdict").get<std::vector<std::string>>();
  comparison.cautions = json.at("cautions").get<std::vector<std::string>>();
  require_consistent(comparison);
  return comparison;
}

}  // namespace

Comparison comparison_from_json(const ordered_json& document, const std::string& place) {
  try {
    return read_comparison(JsonPlace(document), place);
  } catch (const RunFileError&) {
    throw;  // of one of its runs
  } catch (const std::runtime_error& problem) {
    throw RunFileError(fmt::format("{}: {}; not a comparison of schema {}", place, problem.what(),
                                   comparison_schema));
  }
}

std::optional<Comparison> find_comparison(const std::filesystem::path& path) {
  std::error_code unreachable;
  if (std::filesystem::is_directory(path, unreachable))
    return find_comparison(path / "compare.json");
  give_pending_names(directory_of(path));
  if (!std::filesystem::is_regular_file(path, unreachable)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw RunFileError(fmt::format("{}: cannot be read", path.string()));
  KeyLimit limit;
  const auto document = ordered_json::parse(
      text,
      [&limit](int depth, auto event, const ordered_json&) { return limit.keeps(depth, event); },
      false);
  if (!document.is_object() || !document.contains("schema") ||
      document["schema"] != comparison_schema)
    return std::nullopt;
  Comparison comparison = comparison_from_json(document, path.string());
  // A comparison of images can be read without it, but for the error of its reference.
  if (const auto image = path.parent_path() / reference_image;
      comparison.runs.reference.film.value.empty() &&
      std::filesystem::is_regular_file(image, unreachable))
    comparison.runs.reference.film = read_exr(image).rendering.film;
  return comparison;
}

}  // namespace wander::compare
