// What tells a scene from others: its text, and what is in the files that the text names.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wander {

// SHA-256, each of 64 hexadecimal digits.
struct SceneDigest {
  std::string text{};
  std::map<std::string, std::string>
      files{};  // of meshes and textures, by their paths in the scene

  bool operator==(const SceneDigest&) const = default;
};

// As far as both tell: records of programs before this one know nothing of files.
bool may_be_the_same(const SceneDigest& one, const SceneDigest& other);

// One for all of it; where no file is named, that of the text.
std::string whole_digest(const SceneDigest& scene);

// The beginning of one, by which people tell it from others.
std::string_view short_digest(std::string_view digest);

// Of two scenes of one text the files that differ: "NAME (sha256 of `is`), which was (sha256 of `was`)".
std::vector<std::string> changed_files(const SceneDigest& was, const SceneDigest& is);

}  // namespace wander
