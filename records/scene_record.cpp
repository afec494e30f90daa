#include "records/scene_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "records/json_place.h"

namespace wander {

namespace {

using nlohmann::ordered_json;
using Files = std::map<std::string, std::string>;

}  // namespace

ordered_json scene_json(const Provenance& provenance) {
  const SceneDigest& digest = provenance.scene_digest;
  ordered_json json{{"name", provenance.scene_name}, {"sha256", digest.text}};
  if (!digest.files.empty()) json["files"] = digest.files;
  json["text"] = provenance.scene_text;
  return json;
}

void read_scene(const JsonPlace& scene, Provenance& provenance) {
  provenance.scene_name = scene.at("name").get<std::string>();
  provenance.scene_text = scene.at("text").get<std::string>();
  provenance.scene_digest.text = scene.at("sha256").get<std::string>();
  if (const auto files = scene.find("files")) provenance.scene_digest.files = files->get<Files>();
}

std::string scene_files_text(const SceneDigest& scene) {
  return ordered_json(scene.files).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void read_scene_files(const std::string& text, SceneDigest& scene) {
  try {
    const ordered_json document = parsed_json(text);
    scene.files = JsonPlace(document).get<Files>();
  } catch (const std::runtime_error& problem) {
    throw std::runtime_error(
        fmt::format("its attribute 'scene_files' is no list of files ({})", problem.what()));
  }
}

}  // namespace wander
