// PNG images in memory, of colours from a table.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace wander {

using Rgb = std::array<std::uint8_t, 3>;

// Rows from the top; every index is below colours.size(), which is at most 256.
std::string to_png(std::span<const std::uint8_t> indices, int width, int height,
                   std::span<const Rgb> colours);

// An image as the address of itself, to be embedded in a document: data:image/png;base64,…
std::string png_address(const std::string& png);

}  // namespace wander
