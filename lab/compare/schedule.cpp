#include "lab/compare/schedule.h"

namespace wander::compare {

namespace {

constexpr std::uint64_t run_bits = 20;
constexpr std::uint64_t most_references = most_runs / 2;  // and as many trials

// 33 bits of splitmix64.
std::uint64_t hashed(std::uint64_t seed) {
  std::uint64_t z = seed + 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return (z ^ (z >> 31)) >> 31;
}

}  // namespace

std::vector<Turn> schedule(const Grid& grid, std::uint64_t seed) {
  std::vector<Turn> turns;
  std::uint64_t round = 0;
  for (std::size_t r = 0; r < grid.replicates; ++r)
    for (std::size_t b = 0; b < grid.budgets; ++b, ++round)
      for (std::size_t place = 0; place < grid.contenders; ++place) {
        // Over the replicates of one budget, too, everyone moves on by one place a time.
        const std::size_t contender = (place + r + b) % grid.contenders;
        const std::uint64_t run = round * grid.contenders + contender;
        turns.push_back({contender, b, r, (hashed(seed) << run_bits) + run});
      }
  return turns;
}

std::uint64_t reference_seed(std::uint64_t seed, std::uint64_t run) {
  return (hashed(seed) << run_bits) + most_runs + run % most_references;
}

std::uint64_t trial_seed(std::uint64_t seed, std::uint64_t run) {
  return (hashed(seed) << run_bits) + most_runs + most_references + run % most_references;
}

}  // namespace wander::compare
