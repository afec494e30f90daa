// A scene of Mitsuba, 3.x or 0.6, as a scene file and its meshes.  What maps to what:
// docs/importing.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/import/diagnosis.h"
#include "scenes/import/mesh_store.h"
#include "scenes/import/xml_loader.h"

namespace wander {

struct ImportRequest {
  std::filesystem::path file;
  std::string name;         // of the scene
  std::string mesh_folder;  // beside the scene file
  XmlParameters parameters{};
  Fidelity fidelity = Fidelity::exact;
};

// Of what the parts of the scene came from, for faults that are found in the scene.
struct ImportSources {
  std::vector<XmlPlace> shapes;
  std::map<std::string, XmlPlace> materials;  // by name
  XmlPlace camera, scene;
};

struct ImportedScene {
  std::string text;  // a scene file
  std::vector<ImportedFile> files;
  std::vector<ImportFault> approximations;  // and notes
  std::size_t shapes = 0, materials = 0;
  ImportSources sources;
};

// Throws ImportError with all faults.
ImportedScene import_mitsuba(const ImportRequest& request);

// The scene is written in a folder with its meshes: throws ImportError if it is no valid scene file,
// with faults at the places where the parts came from.
void check_imported(const ImportedScene& scene, const std::filesystem::path& folder);

}  // namespace wander
