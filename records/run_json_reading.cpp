#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "records/film_columns.h"
#include "records/run_json.h"

namespace wander {

using nlohmann::ordered_json;

namespace {

double number_from(const ordered_json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers_from(const ordered_json& json) {
  std::vector<double> values;
  for (const ordered_json& value : json) values.push_back(number_from(value));
  return values;
}

template <class E>
E estimate_from(const ordered_json& json) {
  E estimate;
  estimate.value = number_from(json.at("value"));
  estimate.standard_error = number_from(json.at("standard_error"));
  return estimate;
}

FilmEstimate film_from(const ordered_json& json) {
  FilmEstimate film;
  film.shape = json.at("shape").get<std::vector<int>>();
  film.value = numbers_from(json.value("value", ordered_json::array()));
  film.standard_error = numbers_from(json.value("standard_error", ordered_json::array()));
  film.reliable = json.value("reliable", std::vector<bool>{});
  film.degrees_of_freedom = number_from(json.at("degrees_of_freedom"));
  if (film.standard_error.size() != film.value.size() || film.reliable.size() != film.value.size())
    throw std::runtime_error("the film's lists differ in length");
  return film;
}

FilmEstimate chains_film_from(const ordered_json& json, const FilmEstimate& film) {
  FilmEstimate alone{.shape = film.shape};
  alone.value = numbers_from(json.value("value", ordered_json::array()));
  alone.standard_error = numbers_from(json.value("standard_error", ordered_json::array()));
  return alone;
}

Adaptation adaptation_from(const ordered_json& json) {
  Adaptation adaptation{json.at("kernel")};
  for (const ordered_json& each : json.at("tried"))
    adaptation.tried.push_back({each.at("kernel"), number_from(each.at("spread"))});
  return adaptation;
}

PoolingRecord pooling_from(const ordered_json& json) {
  PoolingRecord pooling{{{number_from(json.at("border"))},
                         number_from(json.at("samples_per_step")),
                         number_from(json.at("steps_per_draw")),
                         number_from(json.at("cost_of_sample"))},
                        json.at("samples"),
                        number_from(json.at("light_of_samples"))};
  for (const ordered_json& each : json.value("by_class", ordered_json::array()))
    pooling.classes.push_back(
        {each.at("class"), number_from(each.at("light")), number_from(each.at("of_samples"))});
  return pooling;
}

Normalization normalization_from(const ordered_json& json) {
  auto normalization = estimate_from<Normalization>(json);
  normalization.method = json.at("method");
  for (const auto& [name, entry] : json.at("estimates").items()) {
    auto estimate = estimate_from<NormalizationEstimate>(entry);
    estimate.samples = entry.at("samples");
    estimate.degrees_of_freedom = entry.at("degrees_of_freedom");
    estimate.failure = entry.value("failure", "");
    normalization.estimates[name] = estimate;
  }
  for (const ordered_json& entry : json.at("by_length")) {
    auto share = estimate_from<LengthShare>(entry);
    share.vertices = entry.at("vertices");
    normalization.by_length.push_back(share);
  }
  return normalization;
}

ChainsRecord chains_from(const ordered_json& json) {
  ChainsRecord chains;
  chains.draws = json.at("draws");
  chains.stride = json.at("stride");
  chains.longest_rejection_run = json.at("longest_rejection_run");
  for (const auto& [name, r_hat] : json.at("r_hat").items()) {
    const ordered_json& ess = json.at("ess").at(name);
    chains.functionals.push_back({name, number_from(r_hat), number_from(ess.at("bulk")),
                                  number_from(ess.at("tail")),
                                  number_from(json.at("integrated_autocorrelation").at(name))});
  }
  return chains;
}

template <class Record>
Record outcomes_from(const ordered_json& json) {
  Record record;
  record.proposed = json.at("proposed");
  record.accepted = json.at("accepted");
  record.mean_acceptance = number_from(json.at("mean_acceptance"));
  record.failures = json.at("failures").get<decltype(record.failures)>();
  return record;
}

std::vector<PathsRecord> paths_from(const ordered_json& json) {
  std::vector<PathsRecord> records;
  for (const ordered_json& entry : json) {
    records.push_back(outcomes_from<PathsRecord>(entry));
    records.back().vertices = entry.value("vertices", 0);
    records.back().path_class = entry.value("class", "");
  }
  return records;
}

std::vector<MutationRecord> mutations_from(const ordered_json& json) {
  std::vector<MutationRecord> mutations;
  for (const auto& [name, entry] : json.items()) {
    auto mutation = outcomes_from<MutationRecord>(entry);
    mutation.name = name;
    mutation.seconds = number_from(entry.value("seconds", ordered_json()));
    mutation.squared_jump = number_from(entry.value("squared_jump", ordered_json()));
    mutation.longest_rejection_run = entry.value("longest_rejection_run", std::uint64_t{0});
    mutation.by_length = paths_from(entry.value("by_length", ordered_json::array()));
    mutation.by_class = paths_from(entry.value("by_class", ordered_json::array()));
    mutations.push_back(std::move(mutation));
  }
  return mutations;
}

std::vector<MergedRun> merged_from(const ordered_json& json) {
  std::vector<MergedRun> runs;
  for (const ordered_json& entry : json)
    runs.push_back({entry.at("seed"), entry.at("samples"), number_from(entry.at("seconds")),
                    entry.at("complete")});
  return runs;
}

Rendering rendering_from(const ordered_json& json) {
  Rendering rendering;
  rendering.complete = json.at("complete");
  rendering.method = json.at("method");
  rendering.samples = json.at("samples");
  rendering.seed = json.at("seed");
  rendering.merged = merged_from(json.value("merged", ordered_json::array()));
  rendering.threads = json.at("threads");
  rendering.seconds = number_from(json.at("seconds"));
  rendering.processor_seconds = number_from(json.value("cpu_seconds", ordered_json()));
  rendering.seed_seconds = number_from(json.at("seed_seconds"));
  rendering.precision = json.at("precision");
  rendering.film = film_from(json.at("film"));
  if (json["film"].contains("chains"))
    rendering.chains_film = chains_film_from(json["film"]["chains"], rendering.film);
  if (json.contains("adaptation")) rendering.adaptation = adaptation_from(json["adaptation"]);
  if (json.contains("pooling")) rendering.pooling = pooling_from(json["pooling"]);
  if (rendering.pooling && json["film"].contains("samples"))
    rendering.pooling->film_of_samples =
        numbers_from(json["film"]["samples"].value("value", ordered_json::array()));
  require_parts_of(rendering);
  if (json.contains("normalization"))
    rendering.normalization = normalization_from(json["normalization"]);
  if (json.contains("chains")) {
    rendering.chains = json["chains"].at("count");
    rendering.groups = json["chains"].at("groups");
    if (json["chains"].contains("r_hat")) rendering.chains_record = chains_from(json["chains"]);
  }
  if (json.contains("mutations")) rendering.mutations = mutations_from(json["mutations"]);
  rendering.warnings = json.at("warnings").get<std::vector<std::string>>();
  return rendering;
}

}  // namespace

FilmEstimate film_from_json(const ordered_json& json) { return film_from(json); }

Origin origin_from_json(const ordered_json& document) {
  Origin origin;
  const ordered_json known = document.value("provenance", ordered_json::object());
  for (const OriginField& field : origin_fields)
    origin.*field.member = known.value(field.name, std::string());
  return origin;
}

RunRecord run_from_json(const ordered_json& document, const std::string& place) {
  try {
    if (document.at("schema") != run_schema) throw std::runtime_error("its schema is another");
    const ordered_json& scene = document.at("scene");
    const Provenance provenance{scene.at("name"),
                                scene.at("text"),
                                scene.at("sha256"),
                                document.at("dimension"),
                                document.at("command_line"),
                                document.at("version"),
                                origin_from_json(document)};
    return {rendering_from(document), provenance};
  } catch (const std::exception& problem) {
    throw RunFileError(
        fmt::format("{}: not a run of schema {}: {}", place, run_schema, problem.what()));
  }
}

}  // namespace wander
