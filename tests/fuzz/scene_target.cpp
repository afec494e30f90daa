#include "scenes/format/scene_file.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

const Target scene_target{"scene", [](std::string_view bytes, const std::filesystem::path& folder) {
                            write_bytes(folder / "scene.json", bytes);
                            read_scene_file(folder / "scene.json");
                          }};

}  // namespace wander::fuzz
