// Indices of refraction that Mitsuba knows by name.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wander {

// At 589 nm, such as of "bk7" and "air".
std::optional<double> index_of_refraction(std::string_view name);
std::vector<std::string> substances();

// Of a metal, such as "Au"; at red, green and blue.
struct MetalConstants {
  std::array<double, 3> eta, k;
};
std::optional<MetalConstants> metal_constants(std::string_view name);
std::vector<std::string> metals();

// As seen from a medium with this index.
MetalConstants relative(const MetalConstants& metal, double outside);

// Of light that falls along the normal.
std::array<double, 3> normal_reflectance(const MetalConstants& metal);

}  // namespace wander
