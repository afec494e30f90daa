// PNG images in memory, in sRGB.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace wander {

using Rgb = std::array<std::uint8_t, 3>;

// Of colours from a table.  Rows from the top; every index is below colours.size(), which is at most
// 256.
std::string to_png(std::span<const std::uint8_t> indices, int width, int height,
                   std::span<const Rgb> colours);

// Of pixels with one channel, grey, or with three.  Rows from the top.
std::string to_png(std::span<const std::uint8_t> pixels, int width, int height, int channels);

// An image as the address of itself, to be embedded in a document: data:image/png;base64,…
std::string png_address(const std::string& png);

}  // namespace wander
