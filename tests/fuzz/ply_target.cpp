#include "tests/fuzz/mesh_scene.h"

namespace wander::fuzz {

const Target ply_target{"ply", [](std::string_view bytes, const std::filesystem::path& folder) {
                          read_mesh_in_a_scene(bytes, "mesh.ply", folder);
                        }};

}  // namespace wander::fuzz
