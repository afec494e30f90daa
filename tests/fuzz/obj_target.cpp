#include "tests/fuzz/mesh_scene.h"

namespace wander::fuzz {

const Target obj_target{"obj", [](std::string_view bytes, const std::filesystem::path& folder) {
                          read_mesh_in_a_scene(bytes, "mesh.obj", folder);
                        }};

}  // namespace wander::fuzz
