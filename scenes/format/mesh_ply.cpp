// PLY [Turk 1994]: a header that says what elements follow, of what properties; then their values,
// as text or binary.  The vertices' x, y and z and the faces' vertex_indices are taken, and nx, ny and
// nz, and texture coordinates under any of their usual names, if they are wanted; all else is passed over.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/mesh_text.h"

namespace wander {

namespace {

struct Scalar {
  std::string_view name, other_name;
  std::size_t size;
  double (*decode)(const char*);
};

template <class T>
double decode(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

constexpr Scalar scalars[] = {
    {"char", "int8", 1, decode<std::int8_t>},    {"uchar", "uint8", 1, decode<std::uint8_t>},
    {"short", "int16", 2, decode<std::int16_t>}, {"ushort", "uint16", 2, decode<std::uint16_t>},
    {"int", "int32", 4, decode<std::int32_t>},   {"uint", "uint32", 4, decode<std::uint32_t>},
    {"float", "float32", 4, decode<float>},      {"double", "float64", 8, decode<double>},
};

struct Property {
  std::string_view name;
  const Scalar* type = nullptr;
  const Scalar* count = nullptr;  // of a list
};
struct Element {
  std::string_view name;
  std::size_t count = 0;
  std::vector<Property> properties{};
};

enum class Encoding { ascii, little, big };

struct Header {
  std::optional<Encoding> encoding;
  std::vector<Element> elements;
};

class HeaderReader {
 public:
  explicit HeaderReader(MeshText& text) : text_(text) {}

  Header header() && {
    std::string_view first = text_.next_line();
    if (take_word(first) != "ply") text_.refuse("this is no PLY file; it begins with \"ply\"");
    for (;;) {
      if (text_.at_end()) text_.refuse("the header has no end; its last line is end_header");
      std::string_view line = text_.next_line();
      const std::string_view keyword = take_word(line);
      if (keyword == "end_header") break;
      if (keyword == "format") read_format(take_word(line));
      if (keyword == "element") read_element(line);
      if (keyword == "property") read_property(line);
    }
    if (!header_.encoding) text_.refuse("the header names no format");
    return std::move(header_);
  }

 private:
  void read_format(std::string_view name) {
    if (name == "ascii")
      header_.encoding = Encoding::ascii;
    else if (name == "binary_little_endian")
      header_.encoding = Encoding::little;
    else if (name == "binary_big_endian")
      header_.encoding = Encoding::big;
    else
      text_.refuse(
          fmt::format("the format {} is not known; formats are ascii, "
                      "binary_little_endian and binary_big_endian",
                      excerpt(name)));
  }
  void read_element(std::string_view line) {
    const std::string_view name = take_word(line);
    const std::int64_t count = integer_of(take_word(line), text_);
    if (count < 0) text_.refuse(fmt::format("{} elements; their number is >= 0", count));
    header_.elements.push_back({name, static_cast<std::size_t>(count)});
  }
  void read_property(std::string_view line) {
    if (header_.elements.empty()) text_.refuse("a property of no element");
    Property property;
    std::string_view type = take_word(line);
    if (type == "list") {
      property.count = scalar(take_word(line));
      type = take_word(line);
    }
    property.type = scalar(type);
    property.name = take_word(line);
    header_.elements.back().properties.push_back(property);
  }
  const Scalar* scalar(std::string_view name) const {
    for (const Scalar& known : scalars)
      if (name == known.name || name == known.other_name) return &known;
    text_.refuse(
        fmt::format("the type {} is not known; types are char, uchar, short, ushort, int, "
                    "uint, float and double",
                    excerpt(name)));
  }

  MeshText& text_;
  Header header_;
};

// Where the values come from.
class AsciiValues {
 public:
  explicit AsciiValues(const MeshText& text) : text_(text) {}
  double next(const Scalar&) { return number_of(text_.next_word(), text_); }
  std::size_t left() const { return text_.rest().size(); }
  [[noreturn]] void refuse(std::string_view what) const { text_.refuse(what); }
  double checked(double value) const { return coordinate(value, text_); }

 private:
  MeshText text_;
};

class BinaryValues {
 public:
  BinaryValues(std::string_view bytes, Encoding encoding)
      : bytes_(bytes),
        is_native_((encoding == Encoding::little) == (std::endian::native == std::endian::little)) {
  }
  double next(const Scalar& type) {
    if (bytes_.size() < type.size)
      throw MeshFileError("the file ends before all of its elements; write it anew");
    char value[8];
    std::memcpy(value, bytes_.data(), type.size);
    bytes_.remove_prefix(type.size);
    if (!is_native_) std::reverse(value, value + type.size);
    return type.decode(value);
  }
  std::size_t left() const { return bytes_.size(); }
  [[noreturn]] void refuse(std::string_view what) const { throw MeshFileError(std::string(what)); }
  double checked(double value) const {
    if (!std::isfinite(value)) refuse("a coordinate is not finite");
    return value;
  }

 private:
  std::string_view bytes_;
  bool is_native_;
};

// 0 and 1 for texture coordinates u and v, else 2.
std::size_t axis_of_coordinate(const Property& property) {
  constexpr std::array<std::array<std::string_view, 2>, 4> names{
      {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
  for (const auto& pair : names)
    for (std::size_t axis = 0; axis < pair.size(); ++axis)
      if (!property.count && property.name == pair[axis]) return axis;
  return 2;
}

template <class Values>
class PlyReader {
 public:
  PlyReader(Values values, MeshWants wanted) : values_(std::move(values)), wanted_(wanted) {}

  Triangles triangles(const Header& header) && {
    bool has_points = false, has_faces = false;
    for (const Element& element : header.elements) {
      if (element.properties.empty()) continue;  // there is nothing to read
      // Each takes so many bytes at least.
      const auto most = [&](std::size_t bytes) {
        return std::min(element.count, values_.left() / bytes);
      };
      has_points |= element.name == "vertex";
      has_faces |= element.name == "face";
      if (element.name == "vertex") {
        refuse_without_coordinates(element);
        result_.points.reserve(most(3));
      }
      if (element.name == "face") result_.corners.reserve(most(4));
      for (std::size_t i = 0; i < element.count; ++i) read(element);
    }
    if (!has_points || !has_faces)
      throw MeshFileError(fmt::format("the file has no element \"{}\"; a mesh has vertex and face",
                                      has_points ? "face" : "vertex"));
    for (const auto& corners : result_.corners)
      for (const std::int32_t corner : corners)
        if (corner < 0 || static_cast<std::size_t>(corner) >= result_.points.size())
          throw MeshFileError(
              fmt::format("a face has the corner {}; the file has {}, counted from 0", corner,
                          result_.points.size()));
    return std::move(result_);
  }

 private:
  void read(const Element& element) {
    std::array<double, 3> point{}, normal{}, place{};
    for (const Property& property : element.properties) {
      if (property.count) {
        read_list(property, element.name == "face" && (property.name == "vertex_indices" ||
                                                       property.name == "vertex_index"));
        continue;
      }
      const double value = values_.next(*property.type);
      if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
        point[static_cast<std::size_t>(property.name[0] - 'x')] = value;
      place[axis_of_coordinate(property)] = value;
      if (is_normal(property)) normal[static_cast<std::size_t>(property.name[1] - 'x')] = value;
    }
    if (element.name != "vertex") return;
    for (const double x : point) values_.checked(x);
    result_.points.push_back(point);
    if (wanted_.coordinates == MeshCoordinates::of_textures)
      result_.coordinates.push_back({values_.checked(place[0]), values_.checked(place[1])});
    if (wanted_.normals == MeshNormals::flat || std::ranges::none_of(element.properties, is_normal))
      return;
    for (const double x : normal) values_.checked(x);
    result_.normals.push_back(normal);
  }

  static bool is_normal(const Property& property) {
    return !property.count && property.name.size() == 2 && property.name[0] == 'n' &&
           property.name[1] >= 'x' && property.name[1] <= 'z';
  }

  void refuse_without_coordinates(const Element& vertex) const {
    for (const std::string_view axis : {"x", "y", "z"})
      if (std::ranges::none_of(vertex.properties, [&](const Property& property) {
            return property.name == axis && !property.count;
          }))
        values_.refuse(fmt::format("a vertex has no property {}; it needs x, y and z", axis));
    if (wanted_.coordinates == MeshCoordinates::none) return;
    for (const std::size_t axis : {0u, 1u})
      if (std::ranges::none_of(vertex.properties, [&](const Property& property) {
            return axis_of_coordinate(property) == axis;
          }))
        values_.refuse(
            "a vertex without texture coordinates, which its material's texture needs; give it "
            "properties u and v");
  }

  void read_list(const Property& property, bool is_face) {
    const double count = integer(*property.count);
    if (count < 0 || count > static_cast<double>(values_.left()))
      values_.refuse(fmt::format("a list of {} values; the file ends before them", count));
    face_.clear();
    for (double i = 0; i < count; ++i) {
      if (is_face)
        face_.push_back(static_cast<std::int32_t>(integer(*property.type)));
      else
        values_.next(*property.type);
    }
    if (is_face && face_.size() < 3)
      values_.refuse(fmt::format("a face of {} corners; a face has 3 or more", face_.size()));
    if (is_face) add_fan(result_, face_);
  }
  double integer(const Scalar& type) {
    const double value = values_.next(type);
    if (value != std::floor(value) || !(std::abs(value) <= INT32_MAX))
      values_.refuse(fmt::format("{} is no integer", value));
    return value;
  }

  Values values_;
  MeshWants wanted_;
  Triangles result_;
  std::vector<std::int32_t> face_;
};

}  // namespace

Triangles parse_ply(std::string_view text, MeshWants wanted) {
  MeshText lines(text);
  const Header header = HeaderReader(lines).header();
  if (header.encoding == Encoding::ascii)
    return PlyReader(AsciiValues(lines), wanted).triangles(header);
  return PlyReader(BinaryValues(lines.rest(), *header.encoding), wanted).triangles(header);
}

}  // namespace wander
