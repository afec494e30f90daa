#include "tests/fuzz/mesh_scene.h"
#include "tools/import_files.h"

namespace wander::fuzz {

namespace {

constexpr std::string_view mesh =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n";

void import(const std::filesystem::path& folder, Fidelity fidelity) {
  const std::filesystem::path out = folder / "out.json";
  std::filesystem::remove_all(folder / mesh_folder_of(out));
  import_to(out, folder / "scene.xml", {}, fidelity);
}

}  // namespace

const Target mitsuba_target{"mitsuba",
                            [](std::string_view bytes, const std::filesystem::path& folder) {
                              write_bytes(folder / "mesh.obj", mesh);
                              write_bytes(folder / "white.png", one_white_texel);
                              write_bytes(folder / "scene.xml", bytes);
                              import(folder, Fidelity::approximate);
                              import(folder, Fidelity::exact);
                            }};

}  // namespace wander::fuzz
