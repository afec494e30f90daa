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

// With a point for each point, normal and place in a picture that some corner has together.
Triangles numbered_alike(const Triangles& mesh) {
  if (mesh.normal_corners.empty() && mesh.coordinate_corners.empty()) return mesh;
  const auto numbers = [&](const auto& corners, std::size_t i, std::size_t k) {
    return (corners.empty() ? mesh.corners : corners)[i][k];
  };
  Triangles result;
  std::map<std::array<std::int32_t, 3>, std::int32_t> known;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    auto& corners = result.corners.emplace_back();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::array together{mesh.corners[i][k], numbers(mesh.normal_corners, i, k),
                                numbers(mesh.coordinate_corners, i, k)};
      const auto [found, is_new] = known.emplace(together, static_cast<std::int32_t>(known.size()));
      corners[k] = found->second;
      if (!is_new) continue;
      const auto [point, normal, place] = together;
      result.points.push_back(mesh.points[static_cast<std::size_t>(point)]);
      if (!mesh.normals.empty())
        result.normals.push_back(normal < 0 ? std::array<double, 3>{}
                                            : mesh.normals[static_cast<std::size_t>(normal)]);
      if (!mesh.coordinates.empty())
        result.coordinates.push_back(mesh.coordinates[static_cast<std::size_t>(place)]);
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
      "property double y\nproperty double z\n{}{}element face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      mesh.points.size(),
      mesh.normals.empty() ? "" : "property double nx\nproperty double ny\nproperty double nz\n",
      mesh.coordinates.empty() ? "" : "property double u\nproperty double v\n",
      mesh.corners.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    for (const double x : mesh.points[i]) append(bytes, x);
    if (!mesh.normals.empty())
      for (const double x : mesh.normals[i]) append(bytes, x);
    if (!mesh.coordinates.empty())
      for (const double x : mesh.coordinates[i]) append(bytes, x);
  }
  for (const auto& corners : mesh.corners) {
    append(bytes, static_cast<unsigned char>(corners.size()));
    for (const std::int32_t corner : corners) append(bytes, corner);
  }
  return bytes;
}

Triangles turned_round(Triangles mesh) {
  for (auto* corners : {&mesh.corners, &mesh.normal_corners, &mesh.coordinate_corners})
    for (auto& three : *corners) std::swap(three[1], three[2]);
  return mesh;
}

}  // namespace wander
