#include "scenes/format/scene_digest.h"

#include <fmt/format.h>

#include "scenes/format/sha256.h"

namespace wander {

bool may_be_the_same(const SceneDigest& one, const SceneDigest& other) {
  return one.text == other.text &&
         (one.files.empty() || other.files.empty() || one.files == other.files);
}

std::string whole_digest(const SceneDigest& scene) {
  if (scene.files.empty()) return scene.text;
  std::string all = scene.text;
  for (const auto& [name, digest] : scene.files) all += fmt::format("\n{}  {}", digest, name);
  return sha256(all);
}

std::string_view short_digest(std::string_view digest) { return digest.substr(0, 12); }

std::vector<std::string> changed_files(const SceneDigest& was, const SceneDigest& is) {
  std::vector<std::string> changed;
  for (const auto& [name, digest] : is.files) {
    const auto before = was.files.find(name);
    if (before == was.files.end() || before->second == digest) continue;
    changed.push_back(fmt::format("{} (sha256 {}, which was {})", name, short_digest(digest),
                                  short_digest(before->second)));
  }
  return changed;
}

}  // namespace wander
