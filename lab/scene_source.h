// Where a verb's SCENE comes from: a scene file, `gallery:NAME` for one that is built in, or `-`
// for standard input.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "records/run_record.h"
#include "scenes/format/scene_file.h"
#include "scenes/gallery_scenes.h"

namespace wander {

inline constexpr std::string_view gallery_prefix = "gallery:";

inline constexpr const char* scene_help = "scene file, gallery:NAME, or - for standard input";

// True if it cannot be anything else: `gallery:NAME` or `-`.
bool is_scene(std::string_view source);
// As messages call it: `-` is <stdin>.
std::string shown_name(const std::string& source);

// Throws SceneFileError for an invalid scene, UsageError for an unknown name.
SceneDocument open_scene(const std::string& source);
// A scene of which a record has kept the text and where it came from, in which its meshes still lie.
SceneDocument reopen_scene(const std::string& text, const std::string& source);

Provenance provenance_of(const SceneDocument& document, const std::string& command_line);

// "SOURCE:LINE:COL: /pointer: what" for each doubt about a valid scene.
std::vector<std::string> scene_warnings(const SceneDocument& document, const std::string& source);

// Throws UsageError with the nearest name.
const GalleryScene& gallery_scene(std::string_view name);
// Those that the scene names.
std::vector<GalleryMesh> meshes_of(const GalleryScene& scene);

}  // namespace wander
