#include <fmt/format.h>

#include <utility>

#include "records/film_columns.h"
#include "records/json_place.h"
#include "records/run_json.h"
#include "records/scene_record.h"

namespace wander {

namespace {

template <class E>
E estimate_from(const JsonPlace& json) {
  E estimate;
  estimate.value = json.at("value").number();
  estimate.standard_error = json.at("standard_error").number();
  return estimate;
}

FilmEstimate film_from(const JsonPlace& json) {
  FilmEstimate film;
  film.shape = json.at("shape").get<std::vector<int>>();
  film.value = json.numbers_if("value");
  film.standard_error = json.numbers_if("standard_error");
  film.reliable = json.value("reliable", std::vector<bool>{});
  film.degrees_of_freedom = json.at("degrees_of_freedom").number();
  if (film.standard_error.size() != film.value.size() || film.reliable.size() != film.value.size())
    throw std::runtime_error("the film's lists differ in length");
  return film;
}

FilmEstimate chains_film_from(const JsonPlace& json, const FilmEstimate& film) {
  FilmEstimate alone{.shape = film.shape};
  alone.value = json.numbers_if("value");
  alone.standard_error = json.numbers_if("standard_error");
  return alone;
}

Adaptation adaptation_from(const JsonPlace& json) {
  Adaptation adaptation{json.at("kernel")};
  for (const JsonPlace& each : json.at("tried").elements())
    adaptation.tried.push_back({each.at("kernel"), each.at("spread").number()});
  return adaptation;
}

// Without an end there is null.
Partition partition_from(const JsonPlace& json) {
  Partition partition{json.at("border").number()};
  if (const double end = json.number_if("end"); std::isfinite(end)) partition.end = end;
  return partition;
}

PoolingRecord pooling_from(const JsonPlace& json) {
  PoolingRecord pooling{{partition_from(json), json.at("samples_per_step").number(),
                         json.at("steps_per_draw").number(), json.at("cost_of_sample").number()},
                        json.at("samples"),
                        json.at("light_of_samples").number()};
  for (const JsonPlace& each : json.elements_if("by_class"))
    pooling.classes.push_back(
        {each.at("class"), each.at("light").number(), each.at("of_samples").number()});
  return pooling;
}

Normalization normalization_from(const JsonPlace& json) {
  auto normalization = estimate_from<Normalization>(json);
  normalization.method = json.at("method");
  for (const auto& [name, entry] : json.at("estimates").members()) {
    auto estimate = estimate_from<NormalizationEstimate>(entry);
    estimate.samples = entry.at("samples");
    estimate.degrees_of_freedom = entry.at("degrees_of_freedom").number();
    estimate.failure = entry.value("failure", std::string());
    normalization.estimates[name] = estimate;
  }
  for (const JsonPlace& entry : json.at("by_length").elements()) {
    auto share = estimate_from<LengthShare>(entry);
    share.vertices = entry.at("vertices");
    normalization.by_length.push_back(share);
  }
  return normalization;
}

ChainsRecord chains_from(const JsonPlace& json) {
  ChainsRecord chains;
  chains.draws = json.at("draws");
  chains.stride = json.at("stride");
  chains.longest_rejection_run = json.at("longest_rejection_run");
  for (const auto& [name, r_hat] : json.at("r_hat").members()) {
    const JsonPlace ess = json.at("ess").at(name);
    chains.functionals.push_back({name, r_hat.number(), ess.at("bulk").number(),
                                  ess.at("tail").number(),
                                  json.at("integrated_autocorrelation").at(name).number()});
  }
  return chains;
}

template <class Record>
Record outcomes_from(const JsonPlace& json) {
  Record record;
  record.proposed = json.at("proposed");
  record.accepted = json.at("accepted");
  record.mean_acceptance = json.at("mean_acceptance").number();
  record.failures = json.at("failures").get<decltype(record.failures)>();
  return record;
}

std::vector<PathsRecord> paths_from(const std::vector<JsonPlace>& entries) {
  std::vector<PathsRecord> records;
  for (const JsonPlace& entry : entries) {
    records.push_back(outcomes_from<PathsRecord>(entry));
    records.back().vertices = entry.value("vertices", 0);
    records.back().path_class = entry.value("class", std::string());
  }
  return records;
}

std::vector<MutationRecord> mutations_from(const JsonPlace& json) {
  std::vector<MutationRecord> mutations;
  for (const auto& [name, entry] : json.members()) {
    auto mutation = outcomes_from<MutationRecord>(entry);
    mutation.name = name;
    mutation.seconds = entry.number_if("seconds");
    mutation.squared_jump = entry.number_if("squared_jump");
    mutation.longest_rejection_run = entry.value("longest_rejection_run", std::uint64_t{0});
    mutation.by_length = paths_from(entry.elements_if("by_length"));
    mutation.by_class = paths_from(entry.elements_if("by_class"));
    mutations.push_back(std::move(mutation));
  }
  return mutations;
}

std::vector<MergedRun> merged_from(const std::vector<JsonPlace>& entries) {
  std::vector<MergedRun> runs;
  for (const JsonPlace& entry : entries)
    runs.push_back({entry.at("seed"), entry.at("samples"), entry.at("seconds").number(),
                    entry.at("complete")});
  return runs;
}

Rendering rendering_from(const JsonPlace& json) {
  Rendering rendering;
  rendering.complete = json.at("complete");
  rendering.method = json.at("method");
  rendering.samples = json.at("samples");
  rendering.seed = json.at("seed");
  rendering.merged = merged_from(json.elements_if("merged"));
  rendering.threads = json.at("threads");
  rendering.seconds = json.at("seconds").number();
  rendering.processor_seconds = json.number_if("cpu_seconds");
  rendering.seed_seconds = json.at("seed_seconds").number();
  rendering.precision = json.at("precision");
  rendering.max_vertices = json.value("max_vertices", 0);
  const JsonPlace film = json.at("film");
  rendering.film = film_from(film);
  if (const auto chains = film.find("chains"))
    rendering.chains_film = chains_film_from(*chains, rendering.film);
  if (const auto adaptation = json.find("adaptation"))
    rendering.adaptation = adaptation_from(*adaptation);
  if (const auto pooling = json.find("pooling")) rendering.pooling = pooling_from(*pooling);
  if (const auto samples = film.find("samples"); samples && rendering.pooling)
    rendering.pooling->film_of_samples = samples->numbers_if("value");
  require_parts_of(rendering);
  if (const auto normalization = json.find("normalization"))
    rendering.normalization = normalization_from(*normalization);
  if (const auto chains = json.find("chains")) {
    rendering.chains = chains->at("count");
    rendering.groups = chains->at("groups");
    if (chains->find("r_hat")) rendering.chains_record = chains_from(*chains);
  }
  if (const auto mutations = json.find("mutations"))
    rendering.mutations = mutations_from(*mutations);
  rendering.warnings = json.at("warnings").get<std::vector<std::string>>();
  return rendering;
}

}  // namespace

FilmEstimate film_from_json(const JsonPlace& json) { return film_from(json); }

Origin origin_from_json(const JsonPlace& document) {
  Origin origin;
  const auto known = document.find("provenance");
  if (!known) return origin;
  for (const OriginField& field : origin_fields)
    origin.*field.member = known->value(field.name, std::string());
  return origin;
}

RunRecord run_from_json(const JsonPlace& document, const std::string& place) {
  try {
    if (document.at("schema").get<std::string>() != run_schema)
      document.at("schema").refuse("its schema is another");
    Provenance provenance;
    read_scene(document.at("scene"), provenance);
    provenance.dimension = document.at("dimension");
    provenance.command_line = document.at("command_line").get<std::string>();
    provenance.version = document.at("version").get<std::string>();
    provenance.origin = origin_from_json(document);
    return {rendering_from(document), provenance};
  } catch (const std::runtime_error& problem) {
    throw RunFileError(
        fmt::format("{}: {}; not a run of schema {}", place, problem.what(), run_schema));
  }
}

}  // namespace wander
