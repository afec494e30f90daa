#include "scenes/import/mesh_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "scenes/format/sha256.h"

namespace wander {

namespace {

static_assert(std::endian::native == std::endian::little, "a PLY file would have to say so");

template <class Value>
void append(std::string& bytes, const Value& value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string plain(std::string name) {
  std::ranges::replace_if(
      name,
      [](char c) {
        return !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                 c == '_' || c == '-' || c == '.');
      },
      '_');
  if (name.starts_with('.')) name.insert(0, "mesh");
  constexpr std::size_t longest = 100;
  return name.size() <= longest ? name : name.substr(name.size() - longest);
}

// With a point for each pair of a point and a normal that some corner has.
Triangles numbered_alike(const Triangles& mesh) {
  if (mesh.normal_corners.empty()) return mesh;
  Triangles result;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> pairs;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    auto& corners = result.corners.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::int32_t point = mesh.corners[i][k], normal = mesh.normal_corners[i][k];
      const auto [pair, is_new] =
          pairs.emplace(std::pair(point, normal), static_cast<std::int32_t>(pairs.size()));
      corners[k] = pair->second;
      if (!is_new) continue;
      result.points.push_back(mesh.points[static_cast<std::size_t>(point)]);
      result.normals.push_back(normal < 0 ? std::array<double, 3>{}
                                          : mesh.normals[static_cast<std::size_t>(normal)]);
    }
  }
  return result;
}

}  // namespace

std::string MeshStore::add(std::string bytes, const std::string& name) {
  const std::string digest = sha256(bytes);
  if (const auto known = known_.find(digest); known != known_.end()) return known->second;
  const std::string file = plain(name);
  const std::size_t dot = std::min(file.rfind('.'), file.size());
  const std::string first = folder_ + "/" + file;
  std::string path = first;
  while (!paths_.insert(path).second)
    path = fmt::format("{}/{}_{}{}", folder_, file.substr(0, dot), 1 + ++numbers_[first],
                       file.substr(dot));
  files_.push_back({path, std::move(bytes)});
  known_[digest] = path;
  return path;
}

std::string ply_of(const Triangles& given) {
  const Triangles mesh = numbered_alike(given);
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
      "property double y\nproperty double z\n{}element face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      mesh.points.size(),
      mesh.normals.empty() ? "" : "property double nx\nproperty double ny\nproperty double nz\n",
      mesh.corners.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (const double x : mesh.points[i]) append(bytes, x);
    if (mesh.normals.empty()) continue;
    for (const double x : mesh.normals[i]) append(bytes, x);
  }
  for (const auto& corners : mesh.corners) {
    append(bytes, static_cast<unsigned char>(corners.size()));
    for (const std::int32_t corner : corners) append(bytes, corner);
  }
  return bytes;
}

Triangles turned_round(Triangles mesh) {
  for (auto* corners : {&mesh.corners, &mesh.normal_corners})
    for (auto& three : *corners) std::swap(three[1], three[2]);
  return mesh;
}

}  // namespace wander
