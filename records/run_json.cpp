#include "records/run_json.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/film_statistics.h"
#include "records/exr.h"
#include "records/film_columns.h"
#include "records/film_netcdf.h"
#include "records/json_place.h"
#include "records/json_text.h"
#include "records/pending_names.h"
#include "records/scene_record.h"
#include "records/temporary_file.h"

namespace wander {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(double x) {
  return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}

ordered_json json_of(const std::vector<double>& values) {
  ordered_json array = ordered_json::array();
  for (const double value : values) array.push_back(json_of(value));
  return array;
}

ordered_json json_of(const Estimate& estimate) {
  return {{"value", json_of(estimate.value)}, {"standard_error", json_of(estimate.standard_error)}};
}

// An image is in film.nc.
bool holds_bins(int dimension) { return dimension == 2; }

ordered_json json_of(const FilmEstimate& film, int dimension) {
  ordered_json json{{"shape", film.shape}};
  if (holds_bins(dimension)) {
    json["value"] = json_of(film.value);
    json["standard_error"] = json_of(film.standard_error);
    json["reliable"] = film.reliable;
  }
  json["degrees_of_freedom"] = json_of(film.degrees_of_freedom);
  return json;
}

// Of the chains alone; a large film has no errors, and an image is in film.nc.
ordered_json chains_of_film(const Rendering& rendering, int dimension) {
  const FilmEstimate& film = *rendering.chains_film;
  ordered_json json{{"mean", json_of(mean_value(film))}};
  if (!film.standard_error.empty()) json["relative_error"] = json_of(relative_error(film));
  if (!holds_bins(dimension)) return json;
  json["value"] = json_of(film.value);
  if (!film.standard_error.empty()) json["standard_error"] = json_of(film.standard_error);
  return json;
}

// What of the film samples carry; of an image it is in film.nc.
bool holds_samples(const Rendering& rendering, int dimension) {
  return holds_bins(dimension) && rendering.pooling && !rendering.pooling->film_of_samples.empty();
}

ordered_json json_of(const Adaptation& adaptation) {
  ordered_json tried = ordered_json::array();
  for (const TriedKernel& each : adaptation.tried)
    tried.push_back({{"kernel", each.factor}, {"spread", json_of(each.spread)}});
  return {{"kernel", adaptation.kernel}, {"tried", tried}};
}

ordered_json json_of(const PoolingRecord& pooling) {
  ordered_json json{{"samples", pooling.samples},
                    {"light_of_samples", json_of(pooling.light_of_samples)},
                    {"border", json_of(pooling.how.partition.c)},
                    {"end", json_of(pooling.how.partition.end)},
                    {"samples_per_step", json_of(pooling.how.samples_per_step)},
                    {"steps_per_draw", json_of(pooling.how.steps_per_draw)},
                    {"cost_of_sample", json_of(pooling.how.cost_of_sample)}};
  for (const ClassRecord& each : pooling.classes)
    json["by_class"].push_back({{"class", each.path_class},
                                {"light", json_of(each.light)},
                                {"of_samples", json_of(each.of_samples)}});
  return json;
}

ordered_json json_of(const Normalization& normalization) {
  ordered_json json = json_of(static_cast<const Estimate&>(normalization));
  json["method"] = normalization.method;
  json["estimates"] = ordered_json::object();
  for (const auto& [name, estimate] : normalization.estimates) {
    ordered_json& entry = json["estimates"][name];
    entry = json_of(static_cast<const Estimate&>(estimate));
    entry["samples"] = estimate.samples;
    entry["degrees_of_freedom"] = json_of(estimate.degrees_of_freedom);
    if (!estimate.failure.empty()) entry["failure"] = estimate.failure;
  }
  json["by_length"] = ordered_json::array();
  for (const LengthShare& share : normalization.by_length)
    json["by_length"].push_back({{"vertices", share.vertices},
                                 {"value", json_of(share.value)},
                                 {"standard_error", json_of(share.standard_error)}});
  return json;
}

// Every functional by its name.
ordered_json json_of(const std::vector<FunctionalRecord>& functionals,
                     const std::function<ordered_json(const FunctionalRecord&)>& value) {
  ordered_json json = ordered_json::object();
  for (const FunctionalRecord& functional : functionals) json[functional.name] = value(functional);
  return json;
}

ordered_json chains_of(const Rendering& rendering) {
  ordered_json json{{"count", rendering.chains}, {"groups", rendering.groups}};
  if (!rendering.chains_record) return json;
  const ChainsRecord& chains = *rendering.chains_record;
  json["draws"] = chains.draws;
  json["stride"] = chains.stride;
  json["longest_rejection_run"] = chains.longest_rejection_run;
  json["r_hat"] = json_of(chains.functionals, [](const auto& f) { return json_of(f.r_hat); });
  json["ess"] = json_of(chains.functionals, [](const auto& f) {
    return ordered_json{{"bulk", json_of(f.ess_bulk)}, {"tail", json_of(f.ess_tail)}};
  });
  json["ess_per_second"] = json_of(
      chains.functionals, [&](const auto& f) { return json_of(f.ess_bulk / rendering.seconds); });
  json["integrated_autocorrelation"] =
      json_of(chains.functionals, [](const auto& f) { return json_of(f.autocorrelation_time); });
  return json;
}

// Of a mutation, and of its part by length or class.
template <class Record>
ordered_json outcomes_of(const Record& record) {
  return {{"proposed", record.proposed},
          {"accepted", record.accepted},
          {"mean_acceptance", json_of(record.mean_acceptance)},
          {"failures", record.failures}};
}

ordered_json json_of(const std::vector<PathsRecord>& records) {
  ordered_json json = ordered_json::array();
  for (const PathsRecord& record : records) {
    ordered_json& entry = json.emplace_back();
    if (record.path_class.empty()) {
      entry["vertices"] = record.vertices;
    } else {
      entry["class"] = record.path_class;
    }
    entry.update(outcomes_of(record));
  }
  return json;
}

ordered_json json_of(const std::vector<MutationRecord>& mutations) {
  ordered_json json = ordered_json::object();
  for (const MutationRecord& mutation : mutations) {
    ordered_json& entry = json[mutation.name] = outcomes_of(mutation);
    entry["seconds"] = json_of(mutation.seconds);
    entry["squared_jump"] = json_of(mutation.squared_jump);
    entry["longest_rejection_run"] = mutation.longest_rejection_run;
    entry["by_length"] = json_of(mutation.by_length);
    entry["by_class"] = json_of(mutation.by_class);
  }
  return json;
}

ordered_json json_of(const std::vector<MergedRun>& runs) {
  ordered_json json = ordered_json::array();
  for (const MergedRun& run : runs)
    json.push_back({{"seed", run.seed},
                    {"samples", run.samples},
                    {"seconds", json_of(run.seconds)},
                    {"complete", run.complete}});
  return json;
}

// A record that was written while the program was killed may lie beside a newer film.
void add_image(Rendering& run, Rendering&& image, const std::filesystem::path& path) {
  if (image.film.shape != run.film.shape || image.method != run.method || image.seed != run.seed ||
      image.samples != run.samples)
    throw RunFileError(fmt::format(
        "{}: it is not of the run of the run.json beside it; compute the run anew, or carry it on",
        path.string()));
  run.film = std::move(image.film);
  run.chains_film = std::move(image.chains_film);
  if (run.pooling && image.pooling)
    run.pooling->film_of_samples = std::move(image.pooling->film_of_samples);
  for (MutationRecord& mutation : run.mutations)
    for (MutationRecord& maps : image.mutations)
      if (maps.name == mutation.name) {
        mutation.acceptance_per_bin = std::move(maps.acceptance_per_bin);
        mutation.proposed_per_bin = std::move(maps.proposed_per_bin);
      }
}

}  // namespace

ordered_json to_json(const RunRecord& run) {
  const int dimension = run.provenance.dimension;
  ordered_json film = json_of(run.rendering.film, dimension);
  if (run.rendering.chains_film) film["chains"] = chains_of_film(run.rendering, dimension);
  if (holds_samples(run.rendering, dimension))
    film["samples"] = {{"value", json_of(run.rendering.pooling->film_of_samples)}};
  return to_json(run, std::move(film));
}

ordered_json to_json(const RunRecord& run, ordered_json film) {
  const Rendering& rendering = run.rendering;
  const Provenance& provenance = run.provenance;
  ordered_json json{{"schema", run_schema},
                    {"complete", rendering.complete},
                    {"scene", scene_json(provenance)},
                    {"dimension", provenance.dimension},
                    {"method", rendering.method},
                    {"samples", rendering.samples},
                    {"seed", rendering.seed}};
  if (!rendering.merged.empty()) json["merged"] = json_of(rendering.merged);
  json["threads"] = rendering.threads;
  json["seconds"] = json_of(rendering.seconds);
  json["cpu_seconds"] = json_of(rendering.processor_seconds);
  json["seed_seconds"] = json_of(rendering.seed_seconds);
  json["precision"] = rendering.precision;
  if (rendering.max_vertices > 0) json["max_vertices"] = rendering.max_vertices;
  json["film"] = std::move(film);
  if (rendering.adaptation) json["adaptation"] = json_of(*rendering.adaptation);
  if (rendering.pooling && rendering.pooling->samples > 0)
    json["pooling"] = json_of(*rendering.pooling);
  if (rendering.normalization) json["normalization"] = json_of(*rendering.normalization);
  if (rendering.chains > 0) json["chains"] = chains_of(rendering);
  if (!rendering.mutations.empty()) json["mutations"] = json_of(rendering.mutations);
  json["command_line"] = provenance.command_line;
  json["version"] = provenance.version;
  json["provenance"] = to_json(provenance.origin);
  json["warnings"] = rendering.warnings;
  return json;
}

ordered_json to_json(const FilmEstimate& film, int dimension) { return json_of(film, dimension); }

ordered_json to_json(const Origin& origin) {
  ordered_json json = ordered_json::object();
  for (const OriginField& field : origin_fields)
    if (const std::string& text = origin.*field.member; !text.empty()) json[field.name] = text;
  return json;
}

namespace {

void write_numbers(const char* name, const std::vector<double>& numbers, JsonText& text) {
  text.key(name).array(numbers.size(), [&](auto i) { return json_of(numbers[i]); });
}

void write_chains_of_film(const RunRecord& run, JsonText& text) {
  const FilmEstimate& alone = *run.rendering.chains_film;
  text.key("chains").open_object();
  text.key("mean").value(json_of(mean_value(alone)));
  if (!alone.standard_error.empty())
    text.key("relative_error").value(json_of(relative_error(alone)));
  if (holds_bins(run.provenance.dimension)) {
    write_numbers("value", alone.value, text);
    if (!alone.standard_error.empty()) write_numbers("standard_error", alone.standard_error, text);
  }
  text.close_object();
}

void write_film(const RunRecord& run, JsonText& text) {
  const FilmEstimate& film = run.rendering.film;
  text.open_object();
  text.key("shape").value(film.shape);
  if (holds_bins(run.provenance.dimension)) {
    write_numbers("value", film.value, text);
    write_numbers("standard_error", film.standard_error, text);
    text.key("reliable").array(film.reliable.size(), [&](auto i) {
      return ordered_json(bool(film.reliable[i]));
    });
  }
  text.key("degrees_of_freedom").value(json_of(film.degrees_of_freedom));
  if (run.rendering.chains_film) write_chains_of_film(run, text);
  if (holds_samples(run.rendering, run.provenance.dimension)) {
    text.key("samples").open_object();
    write_numbers("value", run.rendering.pooling->film_of_samples, text);
    text.close_object();
  }
  text.close_object();
}

}  // namespace

void write_json(const RunRecord& run, int indent, const ByteSink& file) {
  JsonText text(indent, file);
  text.open_object();
  const ordered_json whole = to_json(run, {});
  for (const auto& [key, value] : whole.items()) {
    text.key(key);
    if (key != "film") {
      text.value(value);
      continue;
    }
    write_film(run, text);
  }
  text.close_object();
  file("\n");
}

std::optional<RunRecord> find_run_alone(const std::filesystem::path& path) {
  std::error_code unreachable;
  if (std::filesystem::is_directory(path, unreachable)) return find_run_alone(path / "run.json");
  give_pending_names(directory_of(path));
  if (!std::filesystem::is_regular_file(path, unreachable)) return std::nullopt;
  if (is_exr(path)) return read_exr(path);
  if (is_film_netcdf(path)) return read_film_netcdf(path);
  FilmColumns columns;
  const ordered_json document = columns.read(path);
  if (!document.is_object() || document.value("schema", ordered_json()) != run_schema)
    return std::nullopt;
  RunRecord run = run_from_json(JsonPlace(document), path.string());
  try {
    columns.move_to(run.rendering);
  } catch (const std::runtime_error& problem) {
    throw RunFileError(fmt::format("{}: {}", path.string(), problem.what()));
  }
  return run;
}

std::optional<RunRecord> find_run(const std::filesystem::path& path) {
  std::error_code unreachable;
  if (std::filesystem::is_directory(path, unreachable)) return find_run(path / "run.json");
  std::optional<RunRecord> run = find_run_alone(path);
  if (run && run->rendering.film.value.empty() && !holds_bins(run->provenance.dimension))
    if (const auto image = path.parent_path() / "film.nc";
        std::filesystem::is_regular_file(image, unreachable))
      add_image(run->rendering, read_film_netcdf(image).rendering, image);
  return run;
}

RunRecord read_run(const std::filesystem::path& path) {
  if (auto run = find_run(path)) return *std::move(run);
  throw RunFileError(fmt::format(
      "{}: neither a run.json, a directory with one, a film.exr nor a film.nc", path.string()));
}

}  // namespace wander
