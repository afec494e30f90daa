// Wavefront OBJ: the lines `v x y z` and `f a b c ...`, and if they are wanted `vn x y z` and `vt u v`;
// all others are passed over.  (tinyobjloader
// adds up decimal digits one by one, so that its 0.12 is not that of a scene file, and takes what is
// no number for 0: here both matter.)
#include <fmt/format.h>

#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/mesh_text.h"

namespace wander {

namespace {

constexpr std::string_view no_coordinates =
    "a corner without texture coordinates, which its material's texture needs; a corner with them "
    "is v/vt";

class ObjReader {
 public:
  ObjReader(std::string_view text, MeshWants wanted) : text_(text), wanted_(wanted) {}

  Triangles triangles() && {
    while (!text_.at_end()) {
      std::string_view line = next_line();
      const std::string_view keyword = take_word(line);
      if (keyword == "v") add(line, result_.points);
      if (keyword == "vn" && is_smooth()) add(line, result_.normals);
      if (keyword == "vt" && has_texture()) add(line, result_.coordinates);
      if (keyword == "f") add_face(line);
    }
    corner_.refuse_beyond(result_.points.size());
    normal_.refuse_beyond(result_.normals.size());
    place_.refuse_beyond(result_.coordinates.size());
    if (!result_.normals.empty()) result_.normal_corners = std::move(of_normals_.corners);
    result_.coordinate_corners = std::move(of_coordinates_.corners);
    return std::move(result_);
  }

 private:
  // With those that a backslash at its end joins to it; a comment ends with its line, whatever its last character is.
  std::string_view next_line() {
    std::string_view line = text_.next_line(), rest = line;
    if (!line.ends_with('\\') || take_word(rest).starts_with('#')) return line;
    joined_.clear();
    for (; line.ends_with('\\'); line = text_.at_end() ? "" : text_.next_line())
      joined_.append(line.substr(0, line.size() - 1)).append(" ");
    return joined_.append(line);
  }

  bool is_smooth() const { return wanted_.normals == MeshNormals::smooth; }
  bool has_texture() const { return wanted_.coordinates == MeshCoordinates::of_textures; }

  // What faces name by number, from 1, or back from the last one so far as -1.
  struct Numbered {
    std::string_view name;
    std::size_t highest = 0;
    int line_of_highest = 0;

    void refuse_beyond(std::size_t count) const {
      if (highest > count)
        throw MeshFileError(fmt::format("line {}: there is no {} {}; the file has {}",
                                        line_of_highest, name, highest, count));
    }
  };

  template <class Vectors>
  void add(std::string_view line, Vectors& vectors) {
    auto& vector = vectors.emplace_back();
    for (double& x : vector) x = coordinate(number_of(take_word(line), text_), text_);
  }

  // Corners are a, a/t, a//n or a/t/n.
  void add_face(std::string_view line) {
    face_.clear();
    normals_of_face_.clear();
    places_of_face_.clear();
    for (std::string_view word = take_word(line); !word.empty() && !word.starts_with('#');
         word = take_word(line)) {
      const std::size_t slash = word.find('/');
      face_.push_back(index_of(word.substr(0, slash), corner_, result_.points));
      const std::size_t second = slash == word.npos ? slash : word.find('/', slash + 1);
      if (has_texture())
        add_place(slash == word.npos ? "" : word.substr(slash + 1, second - slash - 1));
      if (!is_smooth()) continue;
      normals_of_face_.push_back(
          second == word.npos ? -1 : index_of(word.substr(second + 1), normal_, result_.normals));
    }
    if (face_.size() < 3)
      text_.refuse(fmt::format("a face of {} corners; a face has 3 or more", face_.size()));
    add_fan(result_, face_);
    if (is_smooth()) add_fan(of_normals_, normals_of_face_);
    if (has_texture()) add_fan(of_coordinates_, places_of_face_);
  }

  void add_place(std::string_view word) {
    if (word.empty()) text_.refuse(no_coordinates);
    places_of_face_.push_back(index_of(word, place_, result_.coordinates));
  }

  template <class Vectors>
  std::int32_t index_of(std::string_view word, Numbered& what, const Vectors& so_far) {
    const std::int64_t number = integer_of(word, text_);
    const auto known = static_cast<std::int64_t>(so_far.size());
    if (number == 0 || number < -known || number > most)
      text_.refuse(
          fmt::format("there is no {0} {1}; {0}s are counted from 1, or back from the last "
                      "as -1",
                      what.name, number));
    if (number < 0) return static_cast<std::int32_t>(known + number);
    if (static_cast<std::size_t>(number) > what.highest) {
      what.highest = static_cast<std::size_t>(number);
      what.line_of_highest = text_.line();
    }
    return static_cast<std::int32_t>(number - 1);
  }

  static constexpr std::int64_t most = INT32_MAX;

  MeshText text_;
  std::string joined_;  // lines
  MeshWants wanted_;
  Triangles result_, of_normals_, of_coordinates_;
  std::vector<std::int32_t> face_, normals_of_face_, places_of_face_;
  Numbered corner_{"corner"}, normal_{"normal"}, place_{"texture coordinate"};
};

}  // namespace

Triangles parse_obj(std::string_view text, MeshWants wanted) {
  return ObjReader(text, wanted).triangles();
}

}  // namespace wander
