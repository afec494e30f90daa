#include "scenes/import/texture.h"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <optional>
#include <vector>

#include "scenes/format/json_text.h"
#include "scenes/format/texture_file.h"
#include "scenes/import/plugin.h"

namespace wander {

namespace {

constexpr double grey_of_unread = 0.5;
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 27;

enum class Encoding { srgb, linear };

// Nothing if the file is no PNG that can be read.
std::optional<Colour> mean_of_png(const std::filesystem::path& path, Encoding encoding) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  image.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> bytes(pixels <= most_pixels ? 4 * pixels : 0);
  const bool is_read =
      !bytes.empty() && png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0;
  png_image_free(&image);
  if (!is_read) return {};
  std::array<double, 256> decoded{};
  for (std::size_t i = 0; i < decoded.size(); ++i) {
    const double value = static_cast<double>(i) / 255;
    decoded[i] = encoding == Encoding::srgb ? linear_of_srgb(value) : value;
  }
  Colour mean{};
  for (std::size_t i = 0; i < bytes.size(); i += 4)
    for (std::size_t channel = 0; channel < 3; ++channel)
      mean[channel] += decoded[bytes[i + channel]];
  for (double& channel : mean) channel /= static_cast<double>(pixels);
  return mean;
}

Colour of_bitmap(Plugin& texture, const ImportContext& context) {
  const std::string name = texture.text("filename", "");
  const Encoding encoding = texture.flag("raw", false) ? Encoding::linear : Encoding::srgb;
  texture.ignore({"filter_type", "wrap_mode", "to_uv", "gamma", "uscale", "vscale", "uoffset",
                  "voffset", "cache", "max_anisotropy", "format", "accel"});
  const XmlElement& where = texture.where("filename");
  const std::filesystem::path path = context.file(where, name);
  if (path.empty()) return {};
  const auto mean = mean_of_png(path, encoding);
  if (mean) {
    context.diagnosis.inexact(texture.element(), fmt::format("the bitmap {}", excerpt(name)),
                              "its mean colour");
    return *mean;
  }
  context.diagnosis.inexact(texture.element(), fmt::format("{}, which is no PNG,", excerpt(name)),
                            fmt::format("a grey of {}", grey_of_unread));
  return {grey_of_unread, grey_of_unread, grey_of_unread};
}

Colour of_checkerboard(Plugin& texture, const ImportContext& context) {
  const Colour a = texture.reflectance("color0", 0.4), b = texture.reflectance("color1", 0.2);
  texture.ignore({"to_uv", "uscale", "vscale", "uoffset", "voffset"});
  context.diagnosis.inexact(texture.element(), "a checkerboard", "its mean colour");
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

}  // namespace

Colour mean_of_texture(const XmlElement& element, const ImportContext& context) {
  Plugin texture(element, context);
  Colour colour{};
  if (element.type() == "bitmap") {
    colour = of_bitmap(texture, context);
  } else if (element.type() == "checkerboard") {
    colour = of_checkerboard(texture, context);
  } else {
    context.diagnosis.fault(
        element, fmt::format("the texture \"{}\" is not known; known are bitmap and checkerboard",
                             excerpt(element.type())));
    return colour;
  }
  texture.done();
  return colour;
}

}  // namespace wander
