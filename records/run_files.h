// The files of a run in its directory.
//
//   film.exr, film.csv, run.json               a row of bins, of a scene in the plane
//   film.exr, film.nc, film.png, run.json      an image
#pragma once

#include <filesystem>
#include <string_view>

#include "core/description.h"
#include "records/run_record.h"

namespace wander {

// All files are complete on the disk before the first takes its name; run.json comes last, so that
// a directory with a run.json holds a whole run.  Files of a former run of the other kind go.
// `exposure` is that of film.png (tone.h).  Throws OutputError.
void write_run(const RunRecord& run, const description::Scene& scene,
               const std::filesystem::path& directory, double exposure = 0);

// The files of a run that the program itself wrote there, if it did.
void remove_run(const std::filesystem::path& directory);

// True if the file begins as a JSON document of this schema.
bool holds_document(const std::filesystem::path& file, std::string_view schema);
// True if the program itself wrote a run there.
bool holds_run(const std::filesystem::path& directory);

}  // namespace wander
