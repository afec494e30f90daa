// A kind of file that anybody may have written, and how the program comes to read it.  Each is
// driven by libFuzzer (libfuzzer.cpp) and, in the quick suite, by a few mutations of its corpus
// (fuzz_test.cpp).
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace wander::fuzz {

struct Target {
  const char* kind;  // corpus/KIND has its seeds
  // Makes a file of the bytes in the folder and reads it as the verbs do.
  void (*read)(std::string_view bytes, const std::filesystem::path& folder);
};

extern const Target checkpoint_target, exr_target, film_target, mitsuba_target, obj_target,
    ply_target, reference_target, run_target, scene_target, texture_target, trajectory_target;

// A file of these bytes.
void write_bytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace wander::fuzz
