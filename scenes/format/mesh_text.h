// The words and numbers of a mesh file, and what its faces are made into.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/geometry/triangles.h"
#include "core/shape_description.h"

namespace wander {

using description::largest_coordinate;

class MeshText {
 public:
  // A byte order mark before it is passed over.
  explicit MeshText(std::string_view text);

  bool at_end() const { return left_.empty(); }
  int line() const { return line_; }
  std::string_view rest() const { return left_; }

  // The next line, without its end; what was left of the line before is passed over.
  std::string_view next_line();
  // The next word, on whatever line; empty at the end.
  std::string_view next_word();

  // Throws MeshFileError with the line.
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  std::string_view left_;
  int line_ = 0;  // of what was read last
  bool line_is_over_ = true;
};

// Takes the first word off a line.
std::string_view take_word(std::string_view& line);

// Throw MeshFileError with the line of the text.
double number_of(std::string_view word, const MeshText& text);
double coordinate(double value, const MeshText& text);  // which is finite
std::int64_t integer_of(std::string_view word, const MeshText& text);

// Indices from 0.
void add_fan(Triangles& triangles, std::span<const std::int32_t> corners);

}  // namespace wander
