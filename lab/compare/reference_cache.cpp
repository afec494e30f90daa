#include "lab/compare/reference_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "records/atomic_file.h"
#include "records/json_place.h"
#include "records/rendering_archive.h"
#include "records/seal.h"
#include "scenes/format/sha256.h"

namespace wander::compare {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr const char* schema = "wanderlight-reference/4";
constexpr std::string_view ending = ".runs";

std::string prefix_of(const Provenance& provenance, int max_vertices) {
  return fmt::format("{}-{}-", whole_digest(provenance.scene_digest), max_vertices);
}

void require_whole(const LongRuns& runs) {
  if (runs.runs.empty()) throw std::runtime_error("it holds no run");
  for (const Rendering& run : runs.runs)
    if (run.film.value.empty() || run.film.shape != runs.runs.front().film.shape ||
        run.film.value.size() != runs.runs.front().film.value.size() || run.samples == 0)
      throw std::runtime_error("its films differ in shape");
}

std::string all_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Of the first line of a file.  None if it is of another version of the program.
std::optional<LongRuns> without_runs(const JsonPlace& document, const Provenance& provenance) {
  if (document.at("schema").get<std::string>() != schema)
    throw std::runtime_error("its schema is another");
  if (document.at("version").get<std::string>() != provenance.version) return std::nullopt;
  return LongRuns{.made_by = document.at("made_by"), .runs = {}};
}

// A line of JSON, and the renderings.
std::optional<LongRuns> read(const fs::path& file, const Provenance& provenance) {
  const std::string whole = all_of(file);
  const auto unbroken = unsealed(whole);
  if (!unbroken) throw std::runtime_error("it is damaged or cut short");
  const std::size_t end = unbroken->find('\n');
  if (end == unbroken->npos) throw std::runtime_error("it has no beginning");
  const ordered_json document = parsed_json(unbroken->substr(0, end));
  std::optional<LongRuns> runs = without_runs(JsonPlace(document), provenance);
  if (!runs) return runs;
  runs->runs = from_archive<std::vector<Rendering>>(unbroken->substr(end + 1));
  require_whole(*runs);
  return runs;
}

}  // namespace

fs::path ReferenceCache::folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  // What is not absolute is to be ignored [XDG Base Directory Specification].
  if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "wanderlight";
  if (const fs::path home = variable("HOME"); home.is_absolute())
    return home / ".cache" / "wanderlight";
  return {};
}

ReferenceCache::ReferenceCache(Provenance provenance, int max_vertices)
    : provenance_(std::move(provenance)), max_vertices_(max_vertices) {}

fs::path ReferenceCache::file_of(const LongRuns& runs) const {
  return folder() / fmt::format("{}{}{}", prefix_of(provenance_, max_vertices_),
                                sha256(runs.made_by).substr(0, 8), ending);
}

std::vector<LongRuns> ReferenceCache::load(const std::vector<int>& shape,
                                           std::vector<std::string>& warnings) const {
  std::vector<LongRuns> found;
  std::vector<fs::path> files;
  std::error_code none;
  remove_leftovers(folder());
  for (const auto& entry : fs::directory_iterator(folder(), none))
    if (entry.path().filename().string().starts_with(prefix_of(provenance_, max_vertices_)) &&
        entry.path().extension() == ending && entry.is_regular_file(none))
      files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    try {
      if (auto runs = read(file, provenance_); runs && runs->runs.front().film.shape == shape)
        found.push_back(*std::move(runs));
    } catch (const std::exception& problem) {
      warnings.push_back(
          fmt::format("{}: no reference can be read from this file of the cache ({}); "
                      "it is ignored, and may be removed",
                      file.string(), problem.what()));
    }
  }
  return found;
}

void ReferenceCache::store(const LongRuns& runs, std::vector<std::string>& warnings) const {
  const ordered_json document{{"schema", schema},
                              {"version", provenance_.version},
                              {"scene",
                               {{"name", provenance_.scene_name},
                                {"sha256", provenance_.scene_digest.text},
                                {"files", provenance_.scene_digest.files}}},
                              {"max_vertices", max_vertices_},
                              {"made_by", runs.made_by}};
  try {
    if (folder().empty()) throw std::runtime_error("neither XDG_CACHE_HOME nor HOME is set");
    fs::create_directories(folder());
    write_file(file_of(runs), sealed(document.dump() + "\n" + archived(runs.runs)));
  } catch (const std::exception& problem) {
    std::string told =
        fmt::format("the reference was not kept for the next time: {}", problem.what());
    if (std::ranges::find(warnings, told) == warnings.end()) warnings.push_back(std::move(told));
  }
}

}  // namespace wander::compare
