// Colours and textures of Mitsuba as linear red, green and blue (Rec. 709).
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>

#include "scenes/import/import_context.h"

namespace wander {

using Colour = std::array<double, 3>;

// Unbounded: of what light meets, as reflected, but a number that may be above 1, such as an index of refraction.
enum class Light { reflected, emitted, unbounded };

// Of <rgb>, <srgb>, <spectrum>, <float>, and of a <texture> its mean; black, with a fault, if it is
// none of them.
Colour colour_of(const XmlElement& element, Light light, const ImportContext& context);

// One number if it is grey.
nlohmann::ordered_json json_of(const Colour& colour);

}  // namespace wander
