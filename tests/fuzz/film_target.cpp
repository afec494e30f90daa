#include "records/run_json.h"
#include "tests/fuzz/netcdf_file.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

const Target film_target{"film", [](std::string_view bytes, const std::filesystem::path& folder) {
                           const std::filesystem::path file = folder / "film.nc";
                           if (write_netcdf(file, bytes, "\nwanderlight-film/1\n")) read_run(file);
                         }};

}  // namespace wander::fuzz
