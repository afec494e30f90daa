// A trajectory as netCDF-4 in the layout of ArviZ (`arviz.from_netcdf`): groups whose variables
// have the dimensions chain, draw first.  A draw is a step; its coordinate is the number of the
// step.
//
//   posterior      sensor_u (raster_x, raster_y in 3D), n_vertices, log_f
//   paths          x, path_class                        the state after the decision
//   start          the same of the state before the first draw, by chain
//   proposal       x, n_vertices, sensor_u, path_class  the path that was proposed, if any
//                  x_reached, x_failure                 what there is of one that failed
//   sample_stats   lp, acceptance_rate, accepted, diverging, mutation, reason,
//                  log_f_current, log_f_proposed, log_forward, log_reverse
//   constant_data  the curves of the scene and its camera
//
// What does not exist is NaN, and -1 where a class is named.  Equal content gives equal bytes.
// The file ends with a seal (seal.h): it is read back only as it was written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/description.h"
#include "records/scene_faces.h"
#include "records/trajectory_record.h"

namespace wander {

std::string to_netcdf(const TrajectoryRecord& record, const description::Scene& scene);

// None if the file is no netCDF-4 at all; RunFileError if it is broken or another one.
std::optional<TrajectoryRecord> find_trajectory(const std::filesystem::path& path);
// The same where a trajectory is required.
TrajectoryRecord read_trajectory(const std::filesystem::path& path);
// The geometry of a scene in space that the file of a trajectory holds.
SceneFaces read_faces(const std::filesystem::path& path);

}  // namespace wander
