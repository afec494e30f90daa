// How a kind of shape describes itself, so that scene files can name it: the keys of its file and
// what a schema cannot say against it.  Curves of the plane: curves.h; surfaces of space: surfaces.h.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wander::description {

// Two coordinates in Flatland, three in Spaceland; the third is zero in Flatland.
using Coordinates = std::array<double, 3>;

// A key of a scene file, and where its value goes; one that is absent leaves what is there.
template <class Kind, class Value>
struct Field {
  const char* key;
  Value Kind::*value;
};
template <class Kind, class Value>
Field(const char*, Value Kind::*) -> Field<Kind, Value>;  // which clang 14 does not find by itself

// What is wrong with a shape that conforms to the schema.
struct Flaw {
  const char* key;  // of the shape
  std::string what;
  std::optional<std::size_t> element{};  // of a list
};
using Flaws = std::vector<Flaw>;

// The fourth powers of all lengths, and of ratios of them, are normal numbers.
inline constexpr double shortest_length = 1e-60, largest_coordinate = 1e60;
inline constexpr const char* too_short =
    "shorter than 1e-60, the least length that can be computed with; enlarge the scene";
inline bool too_near(const Coordinates& a, const Coordinates& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < shortest_length;
}
inline Flaws flaws_of_radius(double radius) {
  if (radius < shortest_length) return {{"radius", too_short}};
  return {};
}

}  // namespace wander::description
