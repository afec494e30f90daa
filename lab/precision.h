// The precisions in which light can be transported, and which scenes fit into them.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/description.h"

namespace wander {

enum class Precision { of_float, of_double };
inline constexpr std::array precisions{Precision::of_float, Precision::of_double};

constexpr std::string_view name_of(Precision precision) {
  return precision == Precision::of_float ? "float" : "double";
}

// Why a scene cannot be held in this precision; empty if it can.  Densities of area are inverse
// lengths, and a float ends at 1e38: float wants all lengths within 1e-15 and 1e15, and reflectances of
// 1e-30 or more.  Every scene fits into double.
std::string why_beyond(Precision precision, const description::Scene& scene);

}  // namespace wander
