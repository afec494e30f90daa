#include "lab/scene_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <span>
#include <system_error>
#include <utility>

#include "lab/failure.h"
#include "lab/nearest.h"
#include "records/version.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/sha256.h"

namespace wander {

namespace {

constexpr std::string_view standard_input = "-";

// Who names a scene of the gallery where there is no file may mean it.
std::string gallery_hint(const std::string& source) {
  const std::filesystem::path path(source);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) return {};
  const std::string name = (path.has_filename() ? path : path.parent_path()).stem();
  for (const GalleryScene& scene : std::span(gallery_scenes, gallery_scene_count))
    if (scene.name == name)
      return fmt::format("; or did you mean {}{}, which comes with the program?", gallery_prefix,
                         name);
  return {};
}

SceneDocument open_file(const std::string& source) {
  try {
    return read_scene_file(source);
  } catch (const SceneFileError& problem) {
    const std::string hint = gallery_hint(source);
    if (hint.empty()) throw;
    std::vector<Fault> faults = problem.faults;
    faults.back().what += hint;
    throw SceneFileError(problem.file, std::move(faults));
  }
}

Triangles gallery_mesh(const std::string& file, MeshWants wanted) {
  for (const GalleryMesh& mesh : std::span(gallery_meshes, gallery_mesh_count))
    if (mesh.file == file) return parse_obj(mesh.text, wanted);
  throw MeshFileError("the gallery has no such mesh; save the scene beside its own");
}

std::string digest_of_gallery_mesh(const std::string& file) {
  const std::span meshes(gallery_meshes, gallery_mesh_count);
  return sha256(std::ranges::find(meshes, file, &GalleryMesh::file)->text);
}

SceneFiles files_of(const std::string& source) {
  if (source == standard_input) return {};
  if (source.starts_with(gallery_prefix))
    return {.mesh = gallery_mesh, .digest = digest_of_gallery_mesh};
  const std::filesystem::path folder = std::filesystem::path(source).parent_path();
  return files_in(folder.empty() ? "." : folder);
}

}  // namespace

bool is_scene(std::string_view source) {
  return source == standard_input || source.starts_with(gallery_prefix);
}

std::string shown_name(const std::string& source) {
  return source == standard_input ? "<stdin>" : source;
}

SceneDocument open_scene(const std::string& source) {
  if (source == standard_input) return read_scene(std::cin, shown_name(source));
  if (!source.starts_with(gallery_prefix)) return open_file(source);
  const GalleryScene& scene = gallery_scene(std::string_view(source).substr(gallery_prefix.size()));
  return parse_scene(scene.text, source, files_of(source));
}

SceneDocument reopen_scene(const std::string& text, const std::string& source) {
  return parse_scene(text, shown_name(source), files_of(source));
}

Provenance provenance_of(const SceneDocument& document, const std::string& command_line) {
  return {.scene_name = document.scene.name,
          .scene_text = document.text,
          .scene_digest = document.digest,
          .dimension = document.scene.dimension,
          .command_line = command_line,
          .version = program_version(),
          .origin = origin_here()};
}

std::vector<std::string> scene_warnings(const SceneDocument& document, const std::string& source) {
  std::vector<std::string> lines;
  for (const Fault& fault : document.warnings)
    lines.push_back(fmt::format("{}:{}:{}: {}: {}", shown_name(source), fault.line, fault.column,
                                fault.pointer, fault.what));
  return lines;
}

std::vector<GalleryMesh> meshes_of(const GalleryScene& scene) {
  std::vector<GalleryMesh> named;
  const std::string_view text = scene.text;
  for (const GalleryMesh& mesh : std::span(gallery_meshes, gallery_mesh_count))
    if (text.find(fmt::format("\"{}\"", mesh.file)) != text.npos) named.push_back(mesh);
  return named;
}

const GalleryScene& gallery_scene(std::string_view name) {
  std::vector<std::string_view> known;
  for (const GalleryScene& scene : std::span(gallery_scenes, gallery_scene_count)) {
    if (scene.name == name) return scene;
    known.emplace_back(scene.name);
  }
  throw UsageError(unknown_word("scene", name, known));
}

}  // namespace wander
