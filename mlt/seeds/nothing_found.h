// Why there is nothing to start chains from.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace wander {

// What to look at where no light is found.
inline constexpr const char* where_light_is_lost =
    "look for walls without a gap, a light or sensor that faces away, or a max_vertices that is "
    "too small";

// No sample of the seed pass found a path from a light to the sensor.
class NoLightFound : public std::runtime_error {
 public:
  explicit NoLightFound(std::uint64_t samples)
      : std::runtime_error(
            "the seed pass tried " + std::to_string(samples) +
            " bidirectional samples and found no light path from a light to the sensor, so no "
            "chain can start; " +
            where_light_is_lost) {}
};

// The run was interrupted before there was anything to keep.
class NothingComputed : public std::runtime_error {
 public:
  explicit NothingComputed(const std::string& before = "the first step")
      : std::runtime_error("interrupted before " + before) {}
};

}  // namespace wander
