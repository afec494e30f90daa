// Bitmaps that a scene file can say as Mitsuba means them: PNG, decoded from sRGB, bilinear, repeated.
#pragma once

#include <array>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <optional>

#include "scenes/import/import_context.h"

namespace wander {

struct PlacedBitmap {
  std::filesystem::path path;
  glm::dmat4 to_uv{1};

  // Of a surface's coordinates in Mitsuba, where v runs down a picture, those here.
  std::array<double, 2> place(std::array<double, 2> uv) const;
};

// The reflectance of a diffuse <bsdf>, which may be in a twosided one; nothing if it is no such bitmap.
// Finds no fault.
std::optional<PlacedBitmap> placed_bitmap(const XmlElement& bsdf, const ImportContext& context);

}  // namespace wander
