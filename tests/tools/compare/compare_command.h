// The program's `compare` in a folder of its own, with a cache of its own.
#pragma once

#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {

using nlohmann::json;

class CompareCommand : public CommandLine {
 protected:
  Outcome compare(const std::string& arguments) const {
    return shell("export XDG_CACHE_HOME=\"$PWD/cache\"; \"$WANDER\" compare " + arguments);
  }
  json compared(const std::string& arguments) const {
    const Outcome outcome = compare(arguments + " --json -q");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
  std::size_t cached_files() const {
    const fs::path cache = folder / "cache" / "wanderlight";
    if (!fs::exists(cache)) return 0;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(cache), fs::directory_iterator{}));
  }
  fs::path cached_file() const {
    return fs::directory_iterator(folder / "cache" / "wanderlight")->path();
  }
};

// The box, with a ceiling that no linear system of diffuse walls describes.
inline std::string mirror_box() {
  std::string scene = box;
  const std::string diffuse = R"("type": "diffuse")";
  return scene.replace(scene.find(diffuse), diffuse.size(), R"("type": "mirror")");
}

inline constexpr const char* tiny = "box.json -m pt,bdpt -b 1k,2k --replicates 3";

}  // namespace wander::test
