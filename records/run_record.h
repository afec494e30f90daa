// A run as it is saved: what was computed, and what made it.  Every writer takes a
// record, and a record can be read back and drawn without the scene file it came from.
#pragma once

#include <stdexcept>
#include <string>

#include "records/origin.h"
#include "records/rendering.h"
#include "scenes/format/scene_digest.h"

namespace wander {

struct Provenance {
  std::string scene_name, scene_text;
  SceneDigest scene_digest{};
  int dimension = 2;
  std::string command_line;  // quoted for a shell
  std::string version;       // of the program
  Origin origin{};           // of what was computed; empty in records from before it was kept
};

struct RunRecord {
  Rendering rendering;
  Provenance provenance;
};

// An input file that is not what it should be; what() names the file and what is wrong.
class RunFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wander
