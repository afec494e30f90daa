// The images of a comparison: which film stands for a contender at a budget, and the files beside
// compare.json that hold films, for it has none of their numbers.
//
//   films/METHOD-BUDGET.exr   of each contender at each budget its first replicate
//   films/reference.exr       what errors are measured against
#pragma once

#include <string>

#include "lab/compare/runs.h"

namespace wander::compare {

inline constexpr const char* films_folder = "films";
inline constexpr const char* reference_image = "films/reference.exr";

// Of a label or a budget only what every system takes in the name of a file; no two cells share one.
std::string film_file(const Runs& runs, std::size_t contender, std::size_t budget);

// The first replicate that there is; null if there is none.
const Run* shown_run(const Runs& runs, std::size_t contender, std::size_t budget);

}  // namespace wander::compare
