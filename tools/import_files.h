// The files of an imported scene: the scene itself, and its meshes and pictures in a folder beside it.
#pragma once

#include <filesystem>

#include "scenes/import/import_mitsuba.h"

namespace wander {

// Beside the scene.
std::filesystem::path mesh_folder_of(const std::filesystem::path& out);

// Whole or not at all.  Throws ImportError with all faults, and OutputError.
ImportedScene import_to(const std::filesystem::path& out, const std::filesystem::path& file,
                        const XmlParameters& parameters, Fidelity fidelity);

}  // namespace wander
