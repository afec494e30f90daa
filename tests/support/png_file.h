// PNG files of any kind, for tests.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <filesystem>
#include <vector>

namespace wander::test {

struct PngKind {
  int colour_type = PNG_COLOR_TYPE_RGB, bits = 8;
  std::vector<png_color> palette{};
};

// The bytes of the rows, top to bottom; those of 16 bits with the high byte first.
inline void write_png(const std::filesystem::path& path, unsigned width, unsigned height,
                      std::vector<png_byte> bytes, const PngKind& kind = {}) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, width, height, kind.bits, kind.colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!kind.palette.empty())
    png_set_PLTE(png, info, kind.palette.data(), static_cast<int>(kind.palette.size()));
  png_write_info(png, info);
  const std::size_t row = bytes.size() / height;
  for (std::size_t y = 0; y < height; ++y) png_write_row(png, bytes.data() + y * row);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

}  // namespace wander::test
