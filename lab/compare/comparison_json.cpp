#include "lab/compare/comparison_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/image_shape.h"
#include "lab/compare/comparison_fields.h"
#include "lab/compare/curves.h"
#include "lab/compare/film_files.h"
#include "records/run_json.h"
#include "records/scene_record.h"

namespace wander::compare {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(double x) {
  return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}

ordered_json json_of(const Measured& m) {
  return {{"value", json_of(m.value)},
          {"low", json_of(m.interval.low)},
          {"high", json_of(m.interval.high)}};
}

template <class Record, class Value, std::size_t n>
void write_fields(ordered_json& json, const Record& record,
                  const std::array<Field<Record, Value>, n>& fields) {
  for (const auto& field : fields) json[field.name] = json_of(record.*field.member);
}

ordered_json json_of(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(json_of(value));
  return list;
}

ordered_json json_of(const Contender& c) {
  return {{"label", c.label}, {"method", c.method}, {"dial", c.dial}, {"setting", c.setting}};
}

ordered_json json_of(const Cell& cell) {
  ordered_json json{
      {"contender", cell.contender}, {"budget", cell.budget}, {"replicates", cell.replicates}};
  write_fields(json, cell, cell_fields);
  write_fields(json, cell, cell_numbers);
  return json;
}

ordered_json curves_of(const Comparison& comparison) {
  ordered_json list = ordered_json::array();
  for (const Curve& curve : comparison.curves) {
    ordered_json json{{"contender", curve.contender}, {"inverse_root", curve.inverse_root}};
    write_fields(json, curve, curve_fields);
    json["extrapolated"] = is_extrapolated(comparison, curve);
    list.push_back(std::move(json));
  }
  return list;
}

ordered_json json_of(const Crossing& crossing) {
  ordered_json json{{"ahead", crossing.ahead},
                    {"behind", crossing.behind},
                    {"significant", crossing.significant},
                    {"p_value", json_of(crossing.p_value)}};
  write_fields(json, crossing, crossing_fields);
  return json;
}

ordered_json json_of(const Profile& profile) {
  return {{"contender", profile.contender},
          {"seconds", json_of(profile.seconds)},
          {"share", json_of(profile.share)}};
}

ordered_json json_of(const Run& run, const RunErrors& errors, int dimension) {
  ordered_json json{{"contender", run.contender},
                    {"budget", run.budget},
                    {"replicate", run.replicate},
                    {"seed", run.seed},
                    {"samples", run.samples},
                    {"seconds", json_of(run.seconds)},
                    {"cpu_seconds", json_of(run.processor_seconds)},
                    {"seed_seconds", json_of(run.seed_seconds)},
                    {"seed_samples", run.seed_samples},
                    {"command", run.command}};
  write_fields(json["errors"], errors, error_fields);
  json["film"] = wander::to_json(run.film, dimension);
  return json;
}

ordered_json json_of(const FailedRun& run) {
  return {{"contender", run.contender},
          {"budget", run.budget},
          {"replicate", run.replicate},
          {"seed", run.seed},
          {"message", run.message}};
}

template <class Record>
ordered_json list_of(const std::vector<Record>& records) {
  ordered_json list = ordered_json::array();
  for (const auto& record : records) list.push_back(json_of(record));
  return list;
}

ordered_json cells_of(const Comparison& comparison) {
  ordered_json list = list_of(comparison.cells);
  if (!is_image(comparison.runs.reference.film.shape)) return list;
  for (ordered_json& cell : list)
    if (cell["replicates"] > 0)
      cell["file"] = film_file(comparison.runs, cell["contender"], cell["budget"]);
  return list;
}

ordered_json json_of(const Reference& reference, int dimension) {
  ordered_json json{{"origin", reference.origin}};
  if (reference.max_vertices > 0) json["max_vertices"] = reference.max_vertices;
  if (is_image(reference.film.shape)) json["file"] = reference_image;
  json["film"] = wander::to_json(reference.film, dimension);
  return json;
}

void write_runs(ordered_json& json, const Comparison& comparison) {
  const Runs& runs = comparison.runs;
  const int dimension = runs.provenance.dimension;
  json["runs"] = ordered_json::array();
  for (std::size_t i = 0; i < runs.runs.size(); ++i)
    json["runs"].push_back(json_of(runs.runs[i], comparison.errors.at(i), dimension));
  json["failures"] = list_of(runs.failures);
  Provenance provenance = runs.provenance;
  provenance.scene_text.clear();  // said once, as is the origin
  provenance.origin = {};
  json["details"] = ordered_json::array();
  for (const Rendering& rendering : runs.details)
    json["details"].push_back(wander::to_json(RunRecord{rendering, provenance}));
}

}  // namespace

ordered_json to_json(const Comparison& comparison) {
  const Runs& runs = comparison.runs;
  const Provenance& provenance = runs.provenance;
  ordered_json json{{"schema", comparison_schema},
                    {"complete", runs.complete},
                    {"verdict", comparison.verdict},
                    {"cautions", comparison.cautions},
                    {"scene", scene_json(provenance)},
                    {"dimension", provenance.dimension},
                    {"command_line", provenance.command_line},
                    {"version", provenance.version},
                    {"provenance", wander::to_json(provenance.origin)},
                    {"warnings", runs.warnings},
                    {"contenders", list_of(runs.contenders)},
                    {"budgets", runs.budgets},
                    {"replicates", runs.replicates},
                    {"time", runs.time == TimeKind::wall ? "wall" : "cpu"},
                    {"decisive_budget", comparison.decisive},
                    {"ranking", comparison.ranking},
                    {"target", json_of(comparison.target)},
                    {"reference", json_of(runs.reference, provenance.dimension)},
                    {"cells", cells_of(comparison)},
                    {"curves", curves_of(comparison)},
                    {"crossings", list_of(comparison.crossings)},
                    {"profiles", list_of(comparison.profiles)}};
  write_runs(json, comparison);
  return json;
}

}  // namespace wander::compare
