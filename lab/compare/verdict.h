// A comparison in two to six plain sentences: who is ahead, from when on and by how much; what is
// not significant; how long it takes to a given error; then the cautions, as many as there is room.
#pragma once

#include "lab/compare/comparison.h"

namespace wander::compare {

// Of all the rest of the comparison.
std::vector<std::string> verdict_of(const Comparison& comparison);

// What the verdict, the report and `inspect` say of a pair: "mlt is ahead of bdpt from 1.7 s on
// (1.2–2.5)", or that it cannot be told which of them is.
std::string standing(const Comparison& comparison, const Crossing& crossing);

// "1.7 s (1.2–2.5)", "extrapolated: about 11 s (8–16)", or why it is not known.
std::string time_to_target(const Comparison& comparison, std::size_t contender);

// "1.1 % (0.9–1.4)", of a share in per cent; "7.4 (5–11)"; a bound that is not known is "?".
std::string percent_with_interval(const Measured& share);
std::string number_with_interval(const Measured& value);
std::string seconds_with_interval(const Measured& seconds);  // "1.7 s (1.2–2.5)"

}  // namespace wander::compare
