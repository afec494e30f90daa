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

constexpr double best_compression = 1040;  // more than deflate reaches
constexpr std::size_t longest_name = 255;  // of an attribute or its type

// Bits of the version: tiles, data that are no pixels, several parts.
constexpr std::int32_t other_kinds = 0x200 | 0x800 | 0x1000;

// By the number of a compression (OpenEXR File Layout): so many lines are packed together, and memory is
// taken for as many, be the picture ever so low.
constexpr std::array<double, 10> lines_together{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
constexpr double usual_lines_together = 16;  // of films of this program

// What a header says of its pixels.
struct Promise {
  double width = 0, height = 0;
  double bytes = 0;  // of a pixel
  double lines = 1;  // that are packed together
};

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

// Names with the type of their numbers and 12 bytes more each, up to an empty one.  Returns the bytes of a
// pixel.
double bytes_of_channels(std::ifstream& file) {
  constexpr std::int32_t half = 1;
  double bytes = 0;
  while (!name_in(file).empty()) {
    bytes += integer_in(file) == half ? 2 : 4;
    file.seekg(12, std::ios::cur);
  }
  return bytes;
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
    bytes_of_channels(file);
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

void read_window(std::ifstream& file, Promise& promise) {
  const std::int32_t left = integer_in(file), top = integer_in(file);
  promise.width = double(integer_in(file)) - left + 1;
  promise.height = double(integer_in(file)) - top + 1;
}

void read_compression(std::ifstream& file, Promise& promise) {
  const int number = file.get();
  if (number < 0 || static_cast<std::size_t>(number) >= lines_together.size()) refuse();
  promise.lines = lines_together[static_cast<std::size_t>(number)];
}

// The pixels, and what the library takes to unpack them.
void require_plausible(const Promise& promise, double file_bytes) {
  const double line = promise.width * promise.bytes, most = best_compression * file_bytes;
  if (!(promise.width > 0 && promise.height > 0 && line * promise.height <= most &&
        line * promise.lines <= usual_lines_together * most))
    throw std::runtime_error("its header promises more than the file holds");
}

}  // namespace

void require_plausible_header(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const auto bytes = static_cast<std::streamoff>(std::filesystem::file_size(path));
  integer_in(file);  // the magic number
  if ((integer_in(file) & other_kinds) != 0)
    throw std::runtime_error("it is in tiles, deep or of several parts");
  Promise promise;
  for (std::string name = name_in(file); !name.empty(); name = name_in(file)) {
    const std::string type = name_in(file);
    const std::int32_t size = integer_in(file);
    const std::streamoff at = file.tellg();
    if (size < 0 || size > bytes - at) refuse();
    if (name == "dataWindow" && size == 16) read_window(file, promise);
    if (name == "compression" && size == 1) read_compression(file, promise);
    if (name == "channels") promise.bytes = bytes_of_channels(file);
    file.seekg(at);
    pass_over(file, type, size);
  }
  require_plausible(promise, static_cast<double>(bytes));
}

}  // namespace wander
