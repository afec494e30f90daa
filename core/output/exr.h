// `film.exr`: the film and everything known per bin as named channels of 32-bit floats, and what
// made it as header attributes.  A film in two dimensions is an image of height 1,
// and a picture over the plane is an image with its rows from the top.
//
//   Y, standard_error.Y, reliable.Y (1 or 0)   the estimate
//   vertices_N.Y                               its part from paths of N vertices
//   acceptance.MUTATION.Y, proposed.MUTATION.Y Markov chain methods
//
// Attributes: scene, scene_name, scene_sha256, command_line, wanderlight_version, seed, method,
// samples, complete (all text), dimension, degrees_of_freedom, and for Markov chain methods
// normalization and normalization_standard_error.
// Equal content gives equal bytes; facts of the execution other than the command line stay out.
#pragma once

#include <filesystem>
#include <string>

#include "core/output/run_record.h"

namespace wander {

std::string to_exr(const RunRecord& run);

// Reads back what the image holds, in 32-bit precision; times are NaN, for it does not hold them.
// Throws RunFileError.
RunRecord read_exr(const std::filesystem::path& path);

}  // namespace wander
