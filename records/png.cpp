#include "records/png.h"

#include <openssl/evp.h>
#include <png.h>

#include <stdexcept>

namespace wander {

std::string to_png(std::span<const std::uint8_t> indices, int width, int height,
                   std::span<const Rgb> colours) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = static_cast<png_uint_32>(colours.size());
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, indices.data(), 0,
                                colours.data()) == 0)
    throw std::runtime_error(std::string("an image cannot be written: ") + image.message);
  bytes.resize(size);
  return bytes;
}

std::string png_address(const std::string& png) {
  std::string text(4 * ((png.size() + 2) / 3), '\0');
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                  reinterpret_cast<const unsigned char*>(png.data()), static_cast<int>(png.size()));
  return "data:image/png;base64," + text;
}

}  // namespace wander
