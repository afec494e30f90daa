// Pictures of textures in files: PNG, grey or in colour, of 8 or 16 bits a channel.
//
// What is transparent is taken for opaque.  A grey picture has one channel, any other three.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "core/texture.h"

namespace wander {

// What is wrong with a file, and a remedy.
struct TextureFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws TextureFileError.
std::shared_ptr<const Texture> read_texture(const std::filesystem::path& path);

// From 0 to 1, of a channel as files of pictures have it.
double linear_of_srgb(double encoded);

}  // namespace wander
