#include "scenes/import/bitmap.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "scenes/import/plugin.h"
#include "scenes/import/transform.h"

namespace wander {

namespace {

std::string value_of(const XmlElement& object, std::string_view name, std::string_view otherwise) {
  for (const XmlElement& child : object.children)
    if (present_name(child.attribute("name")) == name)
      return present_name(child.attribute("value"));
  return std::string(otherwise);
}

bool is_png(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(8, '\0');
  stream.read(start.data(), 8);
  return start == "\x89PNG\r\n\x1a\n";
}

std::optional<PlacedBitmap> of_texture(const XmlElement& texture, const ImportContext& context) {
  PlacedBitmap bitmap;
  for (const XmlElement& child : texture.children) {
    const std::string name = present_name(child.attribute("name"));
    if (name == "filename") bitmap.path = context.known_file(child.attribute("value"));
    if (name == "to_uv") {
      Diagnosis said(Fidelity::exact);
      bitmap.to_uv = transform_of(
          child, context.is_old() ? RotationAxis::normalized : RotationAxis::as_given, said);
      if (said.has_faults()) return {};
    }
    constexpr std::string_view known[] = {"filename", "to_uv",  "filter_type", "wrap_mode",
                                          "raw",      "format", "accel"};
    if (std::ranges::find(known, name) == std::end(known)) return {};
  }
  const bool is_sayable = texture.type() == "bitmap" &&
                          value_of(texture, "filter_type", "bilinear") == "bilinear" &&
                          value_of(texture, "wrap_mode", "repeat") == "repeat" &&
                          value_of(texture, "raw", "false") == "false" && is_png(bitmap.path);
  if (!is_sayable) return {};
  return bitmap;
}

}  // namespace

std::array<double, 2> PlacedBitmap::place(std::array<double, 2> uv) const {
  const glm::dvec4 moved = to_uv * glm::dvec4(uv[0], uv[1], 0, 1);
  return {moved.x, 1 - moved.y};
}

std::optional<PlacedBitmap> placed_bitmap(const XmlElement& bsdf, const ImportContext& context) {
  const bool is_diffuse = bsdf.type() == "diffuse";
  if (!is_diffuse && bsdf.type() != "twosided") return {};
  for (const XmlElement& child : bsdf.children) {
    const XmlElement* object = context.known(child);
    if (object == nullptr) continue;
    if (!is_diffuse && object->tag == "bsdf") return placed_bitmap(*object, context);
    const std::string name = present_name(child.attribute("name"));
    if (is_diffuse && object->tag == "texture" &&
        (name == "reflectance" || name == "diffuse_reflectance"))
      return of_texture(*object, context);
  }
  return {};
}

}  // namespace wander
