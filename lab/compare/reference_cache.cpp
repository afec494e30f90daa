#include "lab/compare/reference_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "records/atomic_file.h"
#include "records/run_json.h"
#include "scenes/format/sha256.h"

namespace wander::compare {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

constexpr const char* schema = "wanderlight-reference/1";

std::string prefix_of(const Provenance& provenance, int max_vertices) {
  return fmt::format("{}-{}-", provenance.scene_sha256, max_vertices);
}

void require_whole(const LongRuns& runs) {
  if (runs.runs.empty()) throw std::runtime_error("it holds no run");
  for (const Rendering& run : runs.runs)
    if (run.film.value.empty() || run.film.shape != runs.runs.front().film.shape ||
        run.film.value.size() != runs.runs.front().film.value.size() || run.samples == 0)
      throw std::runtime_error("its films differ in shape");
}

// None if it is of another version of the program.
std::optional<LongRuns> read(const fs::path& file, const Provenance& provenance) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const ordered_json document = ordered_json::parse(text);
  if (document.at("schema") != schema) throw std::runtime_error("its schema is another");
  if (document.at("version") != provenance.version) return std::nullopt;
  LongRuns runs{.made_by = document.at("made_by"), .runs = {}};
  for (const ordered_json& run : document.at("runs"))
    runs.runs.push_back(run_from_json(run, file.string()).rendering);
  require_whole(runs);
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

fs::path ReferenceCache::file_of(const std::string& made_by) const {
  return folder() /
         (prefix_of(provenance_, max_vertices_) + sha256(made_by).substr(0, 8) + ".json");
}

std::vector<LongRuns> ReferenceCache::load(const std::vector<int>& shape,
                                           std::vector<std::string>& warnings) const {
  std::vector<LongRuns> found;
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder(), none))
    if (entry.path().filename().string().starts_with(prefix_of(provenance_, max_vertices_)) &&
        entry.path().extension() == ".json")
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
  ordered_json document{
      {"schema", schema},
      {"version", provenance_.version},
      {"scene", {{"name", provenance_.scene_name}, {"sha256", provenance_.scene_sha256}}},
      {"max_vertices", max_vertices_},
      {"made_by", runs.made_by},
      {"runs", ordered_json::array()}};
  for (const Rendering& run : runs.runs) document["runs"].push_back(to_json({run, provenance_}));
  try {
    if (folder().empty()) throw std::runtime_error("neither XDG_CACHE_HOME nor HOME is set");
    fs::create_directories(folder());
    write_file(file_of(runs.made_by), document.dump(1) + "\n");
  } catch (const std::exception& problem) {
    warnings.push_back(
        fmt::format("the reference was not kept for the next time: {}", problem.what()));
  }
}

}  // namespace wander::compare
