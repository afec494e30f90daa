#include "lab/kept_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "lab/failure.h"
#include "lab/scene_source.h"

namespace wander {

namespace fs = std::filesystem;

namespace {

// None if it is not to be had there.
std::optional<SceneDocument> in_folder(const std::string& folder, const KeptScene& scene) {
  std::error_code problem;
  if (folder.empty() || !fs::is_directory(folder, problem)) return {};
  try {
    return parse_scene(scene.text, shown_name(scene.source), files_in(folder));
  } catch (const SceneFileError&) {
    return {};
  }
}

// Where its name leads from here.
SceneDocument in_this_place(const KeptScene& scene) {
  try {
    return reopen_scene(scene.text, scene.source);
  } catch (const SceneFileError& problem) {
    if (scene.folder.empty()) throw;
    std::vector<Fault> faults = problem.faults;
    faults.back().what += fmt::format(
        "; the scene was in {} when it was kept: name it where it is now", scene.folder);
    throw SceneFileError(problem.file, std::move(faults));
  }
}

}  // namespace

KeptScene kept_scene(const SceneDocument& document, const std::string& source) {
  KeptScene scene{.source = source, .text = document.text, .digest = document.digest};
  if (is_scene(source) || document.digest.files.empty()) return scene;
  std::error_code problem;
  const fs::path folder = fs::weakly_canonical(fs::absolute(source).parent_path(), problem);
  if (!problem) scene.folder = folder.string();
  return scene;
}

SceneDocument reopened(const KeptScene& scene) {
  std::optional<SceneDocument> found = in_folder(scene.folder, scene);
  if (!scene.folder.empty() && (!found || found->digest != scene.digest))
    if (auto beside = in_folder(scene.beside, scene); beside) found = std::move(beside);
  SceneDocument document = found ? *std::move(found) : in_this_place(scene);
  if (const auto changed = changed_files(scene.digest, document.digest); !changed.empty())
    throw UsageError(fmt::format(
        "{}: what it names is not what it was: {}; put it back, or compute the new scene anew",
        shown_name(scene.source), fmt::join(changed, ", ")));
  return document;
}

SceneDocument reopened(const KeptScene& scene, const std::string& now) {
  if (now.empty()) return reopened(scene);
  SceneDocument document = open_scene(now);
  if (const auto other = difference(scene, kept_scene(document, now)))
    throw UsageError(fmt::format("scene {} is not that of the run: its {}", now, *other));
  return document;
}

std::optional<std::string> difference(const KeptScene& scene, const KeptScene& asked) {
  if (scene.digest == asked.digest) return {};
  const auto shown = [](const KeptScene& one) {
    return fmt::format("{} (sha256 {})", shown_name(one.source), short_digest(one.digest.text));
  };
  if (scene.digest.text != asked.digest.text)
    return fmt::format("scene is {}, not {}", shown(scene), shown(asked));
  return fmt::format("scene has other files: {}",
                     fmt::join(changed_files(scene.digest, asked.digest), ", "));
}

nlohmann::ordered_json to_json(const KeptScene& scene) {
  return {{"source", scene.source},
          {"folder", scene.folder},
          {"sha256", scene.digest.text},
          {"files", scene.digest.files},
          {"text", scene.text}};
}

KeptScene kept_scene_from(const JsonPlace& json) {
  return {
      .source = json.at("source"),
      .folder = json.at("folder"),
      .text = json.at("text"),
      .digest = {json.at("sha256"), json.at("files").get<std::map<std::string, std::string>>()}};
}

}  // namespace wander
