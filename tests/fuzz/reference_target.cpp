#include <cstdlib>
#include <string>
#include <vector>

#include "lab/compare/reference_cache.h"
#include "records/run_record.h"
#include "records/seal.h"
#include "tests/fuzz/own_version.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

// The input is sealed.  What is wrong with a file of the cache is a warning; its words are judged like those
// of a failure.
const Target reference_target{
    "reference", [](std::string_view bytes, const std::filesystem::path& folder) {
      const std::filesystem::path cache = folder / "wanderlight";
      setenv("XDG_CACHE_HOME", folder.c_str(), 1);
      std::filesystem::create_directory(cache);
      write_bytes(cache / "0-8-input.runs", sealed(of_this_version(bytes)));
      Provenance scene;
      scene.scene_digest.text = "0";
      scene.version = program_version();
      std::vector<std::string> warnings;
      compare::ReferenceCache(scene, 8).load({2, 2}, warnings);
      for (const std::string& warning : warnings) throw RunFileError(warning);
    }};

}  // namespace wander::fuzz
