// The scene of a run, as records have it:
//
//   run.json, compare.json   "scene": { "name", "sha256", "files": { PATH: SHA-256 }, "text" }
//   EXR, netCDF              attributes scene_name, scene_sha256, scene_files, scene
//
// The files are the meshes and textures that the text names, and are left out where it names none.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "records/run_record.h"

namespace wander {

class JsonPlace;

nlohmann::ordered_json scene_json(const Provenance& provenance);
// Throws JsonPlaceError.
void read_scene(const JsonPlace& scene, Provenance& provenance);

// The attribute: the "files" of the above, as JSON.
std::string scene_files_text(const SceneDigest& scene);
// Throws std::runtime_error.
void read_scene_files(const std::string& text, SceneDigest& scene);

}  // namespace wander
