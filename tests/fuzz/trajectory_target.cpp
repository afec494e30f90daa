#include "records/trajectory_netcdf.h"
#include "tests/fuzz/netcdf_file.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

const Target trajectory_target{
    "trajectory", [](std::string_view bytes, const std::filesystem::path& folder) {
      const std::filesystem::path file = folder / "trajectory.nc";
      if (!write_netcdf(file, bytes, "")) return;
      if (const auto record = find_trajectory(file); record && record->trajectory.dimension == 3)
        read_faces(file);
    }};

}  // namespace wander::fuzz
