#include "records/film_facts.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>

#include "records/scene_record.h"

namespace wander {

namespace {

// "1 2 3"
std::string seeds_of(const std::vector<MergedRun>& runs) {
  std::string text;
  for (const MergedRun& run : runs) text += (text.empty() ? "" : " ") + std::to_string(run.seed);
  return text;
}

template <class Kind>
const Kind& fact_in(const FilmFacts& facts, const char* name) {
  const auto found = facts.find(name);
  const Kind* fact = found == facts.end() ? nullptr : std::get_if<Kind>(&found->second);
  if (fact == nullptr) throw std::runtime_error(fmt::format("it has no attribute '{}'", name));
  return *fact;
}

const std::string& text_in(const FilmFacts& facts, const char* name) {
  return fact_in<std::string>(facts, name);
}

std::uint64_t count_in(const FilmFacts& facts, const char* name) {
  const std::string& text = text_in(facts, name);
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::runtime_error(fmt::format("its attribute '{}' is not a count", name));
  return count;
}

Provenance provenance_of(const FilmFacts& facts) {
  Provenance provenance{text_in(facts, "scene_name"),
                        text_in(facts, "scene"),
                        {text_in(facts, "scene_sha256"), {}},
                        fact_in<int>(facts, "dimension"),
                        text_in(facts, "command_line"),
                        text_in(facts, "wanderlight_version"),
                        {}};
  if (facts.contains("scene_files"))
    read_scene_files(text_in(facts, "scene_files"), provenance.scene_digest);
  for (const OriginField& field : origin_fields)
    if (facts.contains(field.name)) provenance.origin.*field.member = text_in(facts, field.name);
  return provenance;
}

}  // namespace

FilmFacts facts_of(const RunRecord& run) {
  const Rendering& rendering = run.rendering;
  const Provenance& provenance = run.provenance;
  FilmFacts facts{{"scene", provenance.scene_text},
                  {"scene_name", provenance.scene_name},
                  {"scene_sha256", provenance.scene_digest.text},
                  {"command_line", provenance.command_line},
                  {"wanderlight_version", provenance.version},
                  {"method", rendering.method},
                  {"seed", std::to_string(rendering.seed)},
                  {"samples", std::to_string(rendering.samples)},
                  {"complete", rendering.complete ? "true" : "false"},
                  {"dimension", provenance.dimension},
                  {"degrees_of_freedom", rendering.film.degrees_of_freedom}};
  for (const OriginField& field : origin_fields)
    facts[field.name] = provenance.origin.*field.member;
  if (!provenance.scene_digest.files.empty())
    facts["scene_files"] = scene_files_text(provenance.scene_digest);
  if (rendering.max_vertices > 0) facts["max_vertices"] = rendering.max_vertices;
  if (!rendering.merged.empty()) facts["merged_seeds"] = seeds_of(rendering.merged);
  if (const auto& b = rendering.normalization) {
    facts["normalization"] = b->value;
    facts["normalization_standard_error"] = b->standard_error;
  }
  return facts;
}

RunRecord run_of(const FilmFacts& facts) {
  RunRecord run{{}, provenance_of(facts)};
  Rendering& rendering = run.rendering;
  rendering.complete = text_in(facts, "complete") == "true";
  rendering.method = text_in(facts, "method");
  rendering.samples = count_in(facts, "samples");
  rendering.seed = count_in(facts, "seed");
  rendering.processor_seconds = rendering.seconds = rendering.seed_seconds = not_known;
  if (facts.contains("max_vertices")) rendering.max_vertices = fact_in<int>(facts, "max_vertices");
  rendering.film.degrees_of_freedom = fact_in<double>(facts, "degrees_of_freedom");
  if (facts.contains("normalization")) {
    rendering.normalization.emplace();
    rendering.normalization->value = fact_in<double>(facts, "normalization");
    rendering.normalization->standard_error =
        fact_in<double>(facts, "normalization_standard_error");
  }
  return run;
}

}  // namespace wander
