// Faulty files made of sound ones, the same ones whenever they are made: bytes are flipped, cut
// out, doubled or replaced, and tokens and pieces of other files put in.
#pragma once

#include <string>
#include <vector>

#include "tests/support/generator.h"

namespace wander::fuzz {

// One of the files with some of these done to it.
std::string mutated(const std::vector<std::string>& files, test::Generator& generator);

}  // namespace wander::fuzz
