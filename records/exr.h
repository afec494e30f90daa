// `film.exr`: the film and everything known per pixel as named channels of 32-bit floats, and what
// made it as header attributes.  A film in two dimensions is an image of height 1,
// and a picture over the plane is an image with its rows from the top.
//
//   Y or R, G, B              the estimate; of a scene with colour, red, green and blue
//   LAYER.Y or LAYER.R …      the other layers of film_layers.h: standard_error.Y, reliable.Y,
//                             vertices_N.Y, chains.Y, samples.Y, acceptance.MUTATION.Y,
//                             proposed.MUTATION.Y; what mutations did has the channel Y alone
//
// Attributes: those of film_facts.h; of a picture over the plane, window_low and window_high, its
// lower left and upper right corner in metres (v2d).
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

// Is the file in the format of OpenEXR?  Throws RunFileError where it cannot be read.
bool is_exr(const std::filesystem::path& path);
// Reads back what the image holds, in 32-bit precision; times are NaN, for it does not hold them.
// Throws RunFileError.
RunRecord read_exr(const std::filesystem::path& path);
// Of an image that is a picture over the plane.  Throws RunFileError.
std::optional<PlaneWindow> read_window(const std::filesystem::path& path);

}  // namespace wander
