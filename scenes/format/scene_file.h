// Reading of scene files: from JSON text to a valid description, or to all faults in the text.
//
// A text is valid when it is JSON (with // and /* */ comments), conforms to
// schema/scene.schema.json, and holds together: references resolve, there is one sensor and a
// light, nothing is degenerate, and the meshes and textures that it names can be read.  Any input is safe to
// read: what is too large, too deep or too long is refused before it costs memory, with the same kind
// of message.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/description.h"
#include "scenes/format/scene_digest.h"
#include "scenes/format/scene_file_fault.h"
#include "scenes/format/scene_files.h"

namespace wander {

struct SceneDocument {
  description::Scene scene;
  std::string text;
  SceneDigest digest;
  std::vector<Fault> warnings;  // doubts about the geometry of a valid scene, see lint.h
};

// what() has one line per fault, `FILE:LINE:COL: /json/pointer: what is wrong; what is allowed`, in
// the order of the file.
class SceneFileError : public std::runtime_error {
 public:
  SceneFileError(std::string file, std::vector<Fault> faults);

  const std::string file;
  const std::vector<Fault> faults;
};

// The name stands for the file in messages.  All throw SceneFileError.
SceneDocument parse_scene(std::string text, std::string_view name, const SceneFiles& files = {});
SceneDocument read_scene(std::istream& stream, std::string_view name);
SceneDocument read_scene_file(const std::filesystem::path& path);

}  // namespace wander
