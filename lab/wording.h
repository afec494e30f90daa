// Numbers as people read them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "records/rendering.h"

namespace wander {

std::string count_in_words(double count);  // "950", "1.21 M"
// Of things that are called so: "1 chain", "950 chains".
std::string counted_in_words(std::uint64_t count, std::string_view noun);
std::string duration_in_words(double seconds);  // "0.35 s", "12 s", "3 min 5 s"
std::string steps_in_words(std::uint64_t mutations,
                           std::uint64_t samples);  // "3 M mutations, 5 M samples"
// "300 k samples", or of chains what they did and the samples beside them.
std::string work_in_words(const Rendering& rendering);
std::string percent(double share);  // "1.2 %", "unknown" when it is not finite
// Of the shape of a film: "100 bins", "640 x 480 pixels", width first, "… in colour".
std::string extent_in_words(std::span<const int> film_shape);
// Of a number of a film: "bin 7", "pixel (12, 34)", column first, "… , green".
std::string place_in_words(std::span<const int> film_shape, std::size_t index);
std::string with_error(const Estimate& estimate);  // "0.612 ± 0.004"

}  // namespace wander
