#include "records/exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wander {

namespace {

constexpr std::streamoff beginning = 8;    // the magic number and the version
constexpr double best_compression = 4096;  // more than deflate reaches
constexpr std::size_t longest_name = 255;  // of an attribute or its type

[[noreturn]] void refuse() { throw std::runtime_error("its header is damaged or cut short"); }

// Up to its NUL.
std::string name_in(std::ifstream& file) {
  std::string name;
  for (int c = file.get(); c != 0; c = file.get()) {
    if (c == std::ifstream::traits_type::eof() || name.size() == longest_name) refuse();
    name += static_cast<char>(c);
  }
  return name;
}

// Little-endian.
std::int32_t integer_in(std::ifstream& file) {
  std::array<char, 4> bytes{};
  if (!file.read(bytes.data(), bytes.size())) refuse();
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return static_cast<std::int32_t>(number);
}

// The library reads so many bytes of these types whatever size the file says, and is then elsewhere in it.
struct FixedType {
  std::string_view name;
  std::int32_t size;
};
constexpr std::array fixed_types{FixedType{"box2f", 16},
                                 FixedType{"box2i", 16},
                                 FixedType{"chromaticities", 32},
                                 FixedType{"compression", 1},
                                 FixedType{"deepImageState", 1},
                                 FixedType{"double", 8},
                                 FixedType{"envmap", 1},
                                 FixedType{"float", 4},
                                 FixedType{"int", 4},
                                 FixedType{"keycode", 28},
                                 FixedType{"lineOrder", 1},
                                 FixedType{"m33d", 72},
                                 FixedType{"m33f", 36},
                                 FixedType{"m44d", 128},
                                 FixedType{"m44f", 64},
                                 FixedType{"rational", 8},
                                 FixedType{"tiledesc", 9},
                                 FixedType{"timecode", 8},
                                 FixedType{"v2d", 16},
                                 FixedType{"v2f", 8},
                                 FixedType{"v2i", 8},
                                 FixedType{"v3d", 24},
                                 FixedType{"v3f", 12},
                                 FixedType{"v3i", 12}};

// Names with 16 bytes each, up to an empty one.
void pass_over_channels(std::ifstream& file) {
  while (!name_in(file).empty()) file.seekg(16, std::ios::cur);
}

// Each with its length before it.
void pass_over_strings(std::ifstream& file, std::streamoff end) {
  while (file.tellg() < end) {
    const std::int32_t length = integer_in(file);
    if (length < 0 || length > end - file.tellg()) refuse();
    file.seekg(length, std::ios::cur);
  }
}

// Width and height, and four bytes for each pixel.
void pass_over_preview(std::ifstream& file) {
  const double width = integer_in(file), height = integer_in(file);
  if (width < 0 || height < 0 || width * height > 1 << 30) refuse();
  file.seekg(static_cast<std::streamoff>(4 * width * height), std::ios::cur);
}

// Of whatever type: of one that it does not know, the library keeps the bytes that there are.
void pass_over(std::ifstream& file, std::string_view type, std::int32_t size) {
  const std::streamoff end = file.tellg() + std::streamoff(size);
  const auto fixed = std::ranges::find(fixed_types, type, &FixedType::name);
  if (fixed != fixed_types.end() && fixed->size != size) refuse();
  if (type == "chlist")
    pass_over_channels(file);
  else if (type == "stringvector")
    pass_over_strings(file, end);
  else if (type == "preview")
    pass_over_preview(file);
  else if (type == "idmanifest")  // of deep images, and packed: no film has one
    refuse();
  else
    file.seekg(end);
  if (file.tellg() != end) refuse();
}

// xMin, yMin, xMax, yMax
void require_plausible_window(std::ifstream& file, double file_bytes) {
  const std::int32_t left = integer_in(file), top = integer_in(file);
  const double width = double(integer_in(file)) - left + 1,
               height = double(integer_in(file)) - top + 1;
  if (!(width > 0 && height > 0 && width * height <= best_compression * file_bytes))
    throw std::runtime_error("its header promises more than the file holds");
}

}  // namespace

void require_plausible_header(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const auto bytes = static_cast<std::streamoff>(std::filesystem::file_size(path));
  file.seekg(beginning);
  for (std::string name = name_in(file); !name.empty(); name = name_in(file)) {
    const std::string type = name_in(file);
    const std::int32_t size = integer_in(file);
    const std::streamoff at = file.tellg();
    if (size < 0 || size > bytes - at) refuse();
    if (name == "dataWindow" && size == 16)
      require_plausible_window(file, static_cast<double>(bytes));
    file.seekg(at);
    pass_over(file, type, size);
  }
}

}  // namespace wander
