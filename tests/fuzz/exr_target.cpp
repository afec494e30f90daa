#include "records/exr.h"
#include "records/run_json.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

// What `--reference` and `plot` begin with.
const Target exr_target{"exr", [](std::string_view bytes, const std::filesystem::path& folder) {
                          write_bytes(folder / "film.exr", bytes);
                          read_run(folder / "film.exr");
                          read_window(folder / "film.exr");
                        }};

}  // namespace wander::fuzz
