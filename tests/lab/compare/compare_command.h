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
  // Interrupts the comparison as soon as its --progress json says `phase`; runs of less than 0.1 s
  // may say nothing.
  Outcome interrupted_at(const std::string& phase, const std::string& arguments) const {
    return shell("export XDG_CACHE_HOME=\"$PWD/cache\"; \"$WANDER\" compare " + arguments +
                 " --progress json 2>progress & job=$!; until grep -q '" + phase +
                 "' progress || ! kill -0 $job; do sleep 0.01; done; kill -INT $job; wait $job; "
                 "code=$?; cat progress >&2; exit $code");
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
