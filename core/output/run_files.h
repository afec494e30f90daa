// The files of a run in its directory: film.exr, film.csv (films with one row) and run.json.
#pragma once

#include <filesystem>

#include "core/description.h"
#include "core/output/run_record.h"

namespace wander {

// All files are complete on the disk before the first takes its name; run.json comes last, so that
// a directory with a run.json holds a whole run.  Throws OutputError.
void write_run(const RunRecord& run, const description::Scene& scene,
               const std::filesystem::path& directory);

// True if the program itself wrote a run there.
bool holds_run(const std::filesystem::path& directory);

}  // namespace wander
