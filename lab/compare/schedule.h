// Who runs when, and with which seed.
//
// In every replicate each budget is one round, in which all contenders take one turn each; the
// order is rotated from round to round (a cyclic Latin square [Fisher 1926]), so that a machine
// that grows hot or busy harms all alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wander::compare {

struct Turn {
  std::size_t contender = 0, budget = 0, replicate = 0;
  std::uint64_t seed = 1;
};

struct Grid {
  std::size_t contenders = 1, budgets = 1, replicates = 1;
};

// At most this many runs in a comparison.
inline constexpr std::uint64_t most_runs = std::uint64_t{1} << 19;

// In the order in which the turns are taken.  No two have the same seed.
std::vector<Turn> schedule(const Grid& grid, std::uint64_t seed);

// The seeds of one comparison are 53-bit numbers, which JSON keeps exactly: 33 bits that are a hash
// of `seed`, and the number of the run.  Those of references are others than those of the turns,
// and those of trials are others than both.
std::uint64_t reference_seed(std::uint64_t seed, std::uint64_t run);
std::uint64_t trial_seed(std::uint64_t seed, std::uint64_t run);

}  // namespace wander::compare
