// The files of a comparison in its directory: report.html, compare.json, compare.csv, and
// reference.json, the film that errors are measured against, as a run that `--reference` takes.
#pragma once

#include <filesystem>

#include "lab/compare/comparison.h"

namespace wander::compare {

// All files are complete on the disk before the first takes its name.  Throws OutputError.
void write_comparison(const Comparison& comparison, const std::filesystem::path& directory);

// True if the program itself wrote a comparison there.
bool holds_comparison(const std::filesystem::path& directory);

// The reference as a run; it was not sampled, so it has neither samples nor seed.
RunRecord reference_record(const Runs& runs);

}  // namespace wander::compare
