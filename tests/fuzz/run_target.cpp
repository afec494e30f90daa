#include "records/run_json.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

const Target run_target{"run", [](std::string_view bytes, const std::filesystem::path& folder) {
                          std::filesystem::remove(folder / "film.nc");
                          write_bytes(folder / "run.json", bytes);
                          read_run(folder / "run.json");
                        }};

}  // namespace wander::fuzz
