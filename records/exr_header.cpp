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
bool has_size_of_type(std::string_view type, std::int32_t size) {
  struct Type {
    std::string_view name;
    std::int32_t size;
  };
  constexpr std::array types{
      Type{"int", 4},    Type{"float", 4},          Type{"double", 8},      Type{"box2i", 16},
      Type{"v2f", 8},    Type{"v2d", 16},           Type{"compression", 1}, Type{"lineOrder", 1},
      Type{"box2f", 16}, Type{"chromaticities", 32}};
  const auto found = std::ranges::find(types, type, &Type::name);
  return type == "string" || (found != types.end() && found->size == size);
}

// Names with 16 bytes each, up to an empty one.
void pass_over_channels(std::ifstream& file) {
  while (!name_in(file).empty()) file.seekg(16, std::ios::cur);
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
    if (type == "chlist") {
      pass_over_channels(file);
      if (file.tellg() != at + size) refuse();
    } else if (!has_size_of_type(type, size)) {
      refuse();
    }
    file.seekg(at + size);
  }
}

}  // namespace wander
