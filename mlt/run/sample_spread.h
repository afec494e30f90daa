// How much the paths of a sample have to do with each other.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mlt/run/bin_worth.h"
#include "mlt/run/partition.h"
#include "mlt/run/trial_log.h"

namespace wander {

// Paths that one sample finds come to a bin together, for they share a walk from the sensor: with x_i the light
// l w_B of path i, the samples' part varies so many times as if each path were a sample of its own,
//   Σ_samples Σ_j a_j (Σ_{i on j} x_i)² / Σ_i a_j x_i²,
// with each of the borders.  Long paths come in millions: `is_over`, asked with each sample, says that nobody wants
// to know any more.
std::vector<double> paths_together(std::span<const TrialFindings> groups, const BinWorth& worth,
                                   std::span<const Partition> borders,
                                   const std::function<bool()>& is_over);

}  // namespace wander
