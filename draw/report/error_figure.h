// Figures of a comparison: error against cost, and the time to a target error.  SVG documents.
#pragma once

#include <string>
#include <vector>

#include "draw/figure/style.h"
#include "lab/compare/comparison.h"

namespace wander::report {

// Relative RMSE against seconds, log-log, with intervals, with the times from which on one
// contender is ahead of another, and on to the target beyond the longest run where that is
// extrapolated: dotted, with an open mark.
std::string error_time_figure(const compare::Comparison& comparison, const std::string& title,
                              double width = figure::style::page_width);
std::string error_samples_figure(const compare::Comparison& comparison);

// Ascending, when a replicate comes to the target, of those that do.  Of what the shortest run has
// already reached no more is known than that its time is enough.
std::vector<double> times_shown(const compare::Comparison& comparison,
                                const compare::Profile& profile);
// The share of replicates that reach the target within a time [Dolan and Moré 2002].
std::string profile_figure(const compare::Comparison& comparison);

// The figure against time shows what was not measured.
bool has_extrapolated(const compare::Comparison& comparison);

// The crossings that the figure against time marks.
std::vector<compare::Crossing> marked_crossings(const compare::Comparison& comparison);

}  // namespace wander::report
