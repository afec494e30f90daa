#include "records/png.h"

#include <openssl/evp.h>
#include <png.h>

#include <stdexcept>

namespace wander {

namespace {

png_image image_of(int width, int height, png_uint_32 format) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  return image;
}

std::string bytes_of(png_image& image, const std::uint8_t* pixels, const Rgb* colours) {
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, colours) == 0)
    throw std::runtime_error(std::string("an image cannot be written: ") + image.message);
  bytes.resize(size);
  return bytes;
}

}  // namespace

std::string to_png(std::span<const std::uint8_t> indices, int width, int height,
                   std::span<const Rgb> colours) {
  png_image image = image_of(width, height, PNG_FORMAT_RGB_COLORMAP);
  image.colormap_entries = static_cast<png_uint_32>(colours.size());
  return bytes_of(image, indices.data(), colours.data());
}

std::string to_png(std::span<const std::uint8_t> pixels, int width, int height, int channels) {
  png_image image = image_of(width, height, channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB);
  return bytes_of(image, pixels.data(), nullptr);
}

std::string png_address(const std::string& png) {
  std::string text(4 * ((png.size() + 2) / 3), '\0');
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                  reinterpret_cast<const unsigned char*>(png.data()), static_cast<int>(png.size()));
  return "data:image/png;base64," + text;
}

}  // namespace wander
