// Quantities per bin of a flat film as points of a chart.
#pragma once

#include <span>
#include <vector>

#include "draw/figure/chart.h"
#include "draw/report/subject.h"

namespace wander::report {

// The axis of the film: position on the sensor, or fraction of the film of a camera.
figure::Dimension film_dimension(const Subject& subject);

// A staircase over the film with at most so many steps: neighbours are merged into their mean,
// weighted where there are weights.  Values that are not finite make gaps, and so do steps that
// weigh less than `least_weight`.
std::vector<figure::Point> steps_over_film(const Subject& subject, std::span<const double> values,
                                           std::span<const double> weights, double least_weight,
                                           std::size_t most);
std::vector<figure::Point> steps_over_film(const Subject& subject, std::span<const double> values,
                                           std::size_t most);

}  // namespace wander::report
