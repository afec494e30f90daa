#include "tools/import_files.h"

#include <system_error>

#include "records/atomic_file.h"

namespace wander {

namespace {

namespace fs = std::filesystem;

constexpr const char* folder_suffix = "-meshes";

void move_meshes(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directory(to, error);
  for (const fs::directory_entry& mesh : fs::directory_iterator(from)) {
    if (!error) fs::rename(mesh.path(), to / mesh.path().filename(), error);
    if (error) throw OutputError((to / mesh.path().filename()).string(), error.value());
  }
}

// Everything is on the disk, and valid, before anything gets its name; the scene is last.
void write_scene(const ImportedScene& scene, const fs::path& out) {
  const TemporaryFolder workshop(out);
  const fs::path folder = mesh_folder_of(out);
  if (!scene.files.empty()) fs::create_directory(workshop.path() / folder);
  for (const ImportedFile& file : scene.files) write_file(workshop.path() / file.path, file.bytes);
  check_imported(scene, workshop.path());
  StagedFile file(out, scene.text);
  if (!scene.files.empty()) move_meshes(workshop.path() / folder, out.parent_path() / folder);
  file.commit();
}

}  // namespace

fs::path mesh_folder_of(const fs::path& out) { return out.stem().string() + folder_suffix; }

ImportedScene import_to(const fs::path& out, const fs::path& file, const XmlParameters& parameters,
                        Fidelity fidelity) {
  ImportedScene scene = import_mitsuba({.file = file,
                                        .name = out.stem().string(),
                                        .mesh_folder = mesh_folder_of(out).string(),
                                        .parameters = parameters,
                                        .fidelity = fidelity});
  write_scene(scene, out);
  return scene;
}

}  // namespace wander
