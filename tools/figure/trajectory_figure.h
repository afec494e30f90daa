// Figures of a recorded trajectory, each on a page of its own, and all of them on one page.
#pragma once

#include <string>

#include "core/description.h"
#include "tools/figure/steps.h"

namespace wander::figure {

// What every figure takes.  `chosen` are steps of one mutation or class if the filter says so;
// `whole` are all steps of the same chains and draws, for what needs a series without gaps.
struct TrajectoryPage {
  const description::Scene& scene;
  Steps chosen, whole;
  std::string title;
};

// SVG documents.
std::string paths_figure(const TrajectoryPage& page);
std::string trace_figure(const TrajectoryPage& page);
std::string acceptance_figure(const TrajectoryPage& page);
std::string autocorrelation_figure(const TrajectoryPage& page);
std::string density_figure(const TrajectoryPage& page);
std::string overview(const TrajectoryPage& page);

}  // namespace wander::figure
