// Wavefront OBJ: the lines `v x y z` and `f a b c ...`; all others are passed over.  (tinyobjloader
// adds up decimal digits one by one, so that its 0.12 is not that of a scene file, and takes what is
// no number for 0: here both matter.)
#include <fmt/format.h>

#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/mesh_text.h"

namespace wander {

namespace {

class ObjReader {
 public:
  explicit ObjReader(std::string_view text) : text_(text) {}

  Triangles triangles() && {
    while (!text_.at_end()) {
      std::string_view line = text_.next_line();
      const std::string_view keyword = take_word(line);
      if (keyword == "v") add_point(line);
      if (keyword == "f") add_face(line);
    }
    if (highest_ > result_.points.size())
      throw MeshFileError(fmt::format("line {}: there is no corner {}; the file has {}",
                                      line_of_highest_, highest_, result_.points.size()));
    return std::move(result_);
  }

 private:
  void add_point(std::string_view line) {
    auto& point = result_.points.emplace_back();
    for (double& x : point) x = coordinate(number_of(take_word(line), text_), text_);
  }

  void add_face(std::string_view line) {
    face_.clear();
    for (std::string_view word = take_word(line); !word.empty() && !word.starts_with('#');
         word = take_word(line))
      face_.push_back(index_of(word.substr(0, word.find('/'))));
    if (face_.size() < 3)
      text_.refuse(fmt::format("a face of {} corners; a face has 3 or more", face_.size()));
    add_fan(result_, face_);
  }

  // Corners are counted from 1, or back from the last one so far as -1.
  std::int32_t index_of(std::string_view word) {
    const std::int64_t number = integer_of(word, text_);
    const auto known = static_cast<std::int64_t>(result_.points.size());
    if (number == 0 || number < -known || number > most_points)
      text_.refuse(fmt::format(
          "there is no corner {}; corners are counted from 1, or back from the last as -1",
          number));
    if (number < 0) return static_cast<std::int32_t>(known + number);
    if (static_cast<std::size_t>(number) > highest_) {
      highest_ = static_cast<std::size_t>(number);
      line_of_highest_ = text_.line();
    }
    return static_cast<std::int32_t>(number - 1);
  }

  static constexpr std::int64_t most_points = INT32_MAX;

  MeshText text_;
  Triangles result_;
  std::vector<std::int32_t> face_;
  std::size_t highest_ = 0;
  int line_of_highest_ = 0;
};

}  // namespace

Triangles parse_obj(std::string_view text) { return ObjReader(text).triangles(); }

}  // namespace wander
