// `film.exr`: the film and everything known per bin as named channels of 32-bit floats, and what
// made it as header attributes.  A film in two dimensions is an image of height 1,
// and a picture over the plane is an image with its rows from the top.
//
//   Y, standard_error.Y, reliable.Y (1 or 0)   the estimate
//   vertices_N.Y                               its part from paths of N vertices
//   acceptance.MUTATION.Y, proposed.MUTATION.Y Markov chain methods; of a large film, if at all,
//                                              from the cells of its raster (core/film_layout.h)
//
// Attributes: scene, scene_name, scene_sha256, command_line, wanderlight_version, seed, method,
// samples, complete (all text), dimension, degrees_of_freedom, and for Markov chain methods
// normalization and normalization_standard_error; of a picture over the plane, window_low and
// window_high, its lower left and upper right corner in metres (v2d).
// Equal content gives equal bytes; facts of the execution other than the command line stay out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "records/plane_window.h"
#include "records/run_record.h"

namespace wander {

std::string to_exr(const RunRecord& run);
// A picture over the plane.
std::string to_exr(const RunRecord& run, const PlaneWindow& window);

// Reads back what the image holds, in 32-bit precision; times are NaN, for it does not hold them.
// Throws RunFileError.
RunRecord read_exr(const std::filesystem::path& path);
// Of an image that is a picture over the plane.  Throws RunFileError.
std::optional<PlaneWindow> read_window(const std::filesystem::path& path);

}  // namespace wander
