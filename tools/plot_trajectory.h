// `wander plot FILE.nc`: figures of a recorded trajectory.
#pragma once

#include <string>

#include "records/trajectory_record.h"
#include "tools/plot_options.h"

namespace wander {

// As the lines of an OBJ file (draw/figure/path_lines.h).
std::string trajectory_obj(const TrajectoryRecord& record, const PlotOptions& options);
std::string trajectory_svg(const TrajectoryRecord& record, const PlotOptions& options);

}  // namespace wander
