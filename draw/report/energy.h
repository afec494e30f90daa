// The light of a film by the lengths of its paths, over replicates.
#pragma once

#include <map>
#include <vector>

#include "draw/report/subject.h"

namespace wander::report {

// Mean over bins of the film of paths with so many vertices; its interval is that of Student's t
// over replicates, and not known of a single one.
std::map<int, compare::Measured> energy_by_length(const std::vector<const Run*>& replicates);

}  // namespace wander::report
