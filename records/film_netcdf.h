// `film.nc`: the exact record of an image, in netCDF-4.
//
// Dimensions y (from the top), x and channel; the variable `channel` names the channels, Y or R, G
// and B.  The other variables are the layers of the EXR under the names of film_layers.h, in double
// precision, where the EXR has one channel of floats for each channel of a layer:
//
//   value, standard_error, vertices_N           (y, x, channel)
//   reliable                                    (y, x, channel), true or false
//   acceptance.MUTATION, proposed.MUTATION      (y, x)
//
// The attributes are those of the EXR (film_facts.h), and format = "wanderlight-film/1".
// At the end of the file stand that format in a line of its own, by which the file is known, and a
// seal; netCDF ignores both.  Equal content gives equal bytes.
#pragma once

#include <filesystem>
#include <optional>

#include "records/atomic_file.h"
#include "records/run_record.h"

namespace wander {

// Throws std::logic_error if the film is no image.
void write_film_netcdf(const RunRecord& run, const ByteSink& file);

// Says the end of the file that it is one?  Nothing else of it is read.
bool is_film_netcdf(const std::filesystem::path& path);
// Reads back all that it holds; times are NaN, for it does not hold them.  Throws RunFileError.
RunRecord read_film_netcdf(const std::filesystem::path& path);

}  // namespace wander
