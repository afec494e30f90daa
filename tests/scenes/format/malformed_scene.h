// An invalid scene and the faults that are expected of it.  In its text ^ marks where a fault is
// expected, and is no part of the text.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tests/scenes/format/scene_texts.h"

namespace wander {

struct Marked {
  std::string text;
  std::vector<std::pair<int, int>> places;
};
inline Marked without_marks(const std::string& marked) {
  Marked result;
  int line = 1, column = 1;
  for (const char c : marked) {
    if (c == '^') {
      result.places.emplace_back(line, column);
      continue;
    }
    result.text += c;
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!continues) ++column;
    if (c == '\n') {
      ++line;
      column = 1;
    }
  }
  return result;
}

struct Expected {
  std::string pointer, part;  // of what is said
};
struct Malformed {
  std::string name, text;
  std::vector<Expected> faults;
};
inline void PrintTo(const Malformed& malformed, std::ostream* out) { *out << malformed.name; }

class MalformedScene : public testing::TestWithParam<Malformed> {};

inline std::string name_of(const testing::TestParamInfo<Malformed>& info) {
  return info.param.name;
}

}  // namespace wander
