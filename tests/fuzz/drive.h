// The bounded run of a target, the same whenever it is made.
#pragma once

#include <string>
#include <vector>

#include "tests/fuzz/contract.h"
#include "tests/fuzz/mutator.h"

namespace wander::fuzz {

// The first breach on the files as they are and on so many that are made of them; none if there is none.
inline std::optional<std::string> first_breach(const Target& target,
                                               const std::vector<std::string>& files, int made) {
  for (const std::string& file : files)
    if (auto found = breach(target, file)) return found;
  test::Generator generator(1);
  for (int i = 0; i < made; ++i)
    if (auto found = breach(target, mutated(files, generator))) return found;
  return std::nullopt;
}

}  // namespace wander::fuzz
