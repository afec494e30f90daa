// The files of a comparison in its directory.
//
//   report.html, compare.json, compare.csv
//   reference.json    of rows of bins: the film that errors are measured against, as a run that
//                     `--reference` takes
//   films/*.exr       of images: the same, and a film of each contender at each budget
//                     (lab/compare/film_files.h)
#pragma once

#include <filesystem>

#include "core/description.h"
#include "lab/compare/comparison.h"

namespace wander::compare {

// All files are complete on the disk before the first takes its name.  Films of a former comparison
// go.  Throws OutputError.
void write_comparison(const Comparison& comparison, const description::Scene& scene,
                      const std::filesystem::path& directory);

// The files of a comparison that the program itself wrote there, if it did, finished or not.
void remove_comparison(const std::filesystem::path& directory);

// True if the program itself wrote a comparison there.
bool holds_comparison(const std::filesystem::path& directory);

// The reference as a run; it was not sampled, so it has neither samples nor seed.
RunRecord reference_record(const Runs& runs);

}  // namespace wander::compare
