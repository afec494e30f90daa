// The scene of a run or comparison that is kept, to be opened again when it goes on: its text is kept with it, the
// meshes and textures that the text names are not.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "records/json_place.h"
#include "scenes/format/scene_file.h"

namespace wander {

struct KeptScene {
  std::string source{};  // as it was named
  // Of the scene, if it names files: where it was, whatever place is the present one.
  std::string folder{};
  std::string text{};
  SceneDigest digest{};
  // The directory that keeps it, in which its files may lie, too; this is not written.
  std::string beside{};
};

KeptScene kept_scene(const SceneDocument& document, const std::string& source);

// Throws SceneFileError for a scene that is not valid any more, UsageError where a file that it names has changed.
SceneDocument reopened(const KeptScene& scene);
// The same by a name that leads to it now; where that is empty, by what is kept.  Throws UsageError if it is another.
SceneDocument reopened(const KeptScene& scene, const std::string& now);

// What makes it another scene than `asked`, in words that follow "its"; none if it is the same.
std::optional<std::string> difference(const KeptScene& scene, const KeptScene& asked);

nlohmann::ordered_json to_json(const KeptScene& scene);
KeptScene kept_scene_from(const JsonPlace& json);

}  // namespace wander
