// Random numbers for tests: splitmix64 [Steele, Lea and Flood 2014], written here so that no test of
// the program's generator, nor any oracle, leans on the program.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace wander::test {

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }

  // In [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  // Standard normal [Box and Muller 1958]; 1 - u is never zero.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    const double angle = 2 * std::numbers::pi * uniform();
    return radius * std::cos(angle);
  }

 private:
  std::uint64_t state_;
};

}  // namespace wander::test
