// A writer of SVG documents: elements, attributes and text, nothing of figures.
//
// Lengths are points (1/72 inch) and the document is as large as it says, so a figure comes out in
// print at the size it was laid out for.  Numbers have at most two decimals and never depend on the
// locale; the same calls give the same bytes.  The result is well-formed XML 1.0 whatever the text.
#pragma once

#include <functional>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"

namespace wander::figure {

using Vector = Vec<2, double>;

// At most two decimals, no trailing zeros, never "-0".  Not finite: 0.
std::string number(double value);

// Text for use between tags or in a quoted attribute.  Bytes that are not UTF-8 and characters that
// XML forbids become U+FFFD.
std::string escaped(std::string_view text);

// An estimate in points, on the wide side (bold: style::bold_width times that), for layout without
// font metrics.
double text_width(std::string_view text, double font_size);

// `text`, or its beginning and its end with an ellipsis between them when it would be wider than `width`.
std::string shortened(std::string_view text, double font_size, double width);

// The text in lines that are at most this wide, broken between words; a wider word is shortened.
std::vector<std::string> wrapped(std::string_view text, double font_size, double width);

struct Attribute {
  Attribute(std::string_view name, std::string_view value) : name(name), value(value) {}
  Attribute(std::string_view name, double value) : name(name), value(number(value)) {}

  std::string_view name;
  std::string value;
};
using Attributes = std::initializer_list<Attribute>;

struct TextStyle {
  double size = 7;
  std::string_view anchor = "start";  // start, middle, end
  std::string_view weight = "normal";
  double rotation = 0;  // degrees, clockwise about the position
};

class Svg {
 public:
  // `title` and `description` are what a screen reader says.
  Svg(Vector size, std::string_view title, std::string_view description);

  // An element that stays open, and takes what is written, for as long as the result lives.
  class [[nodiscard]] Scope {
   public:
    Scope(Svg& svg, std::string_view tag) : svg_(svg), tag_(tag) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope();

   private:
    Svg& svg_;
    std::string tag_;
  };
  Scope open(std::string_view tag, Attributes attributes);
  Scope group(std::string_view kind) { return open("g", {{"class", kind}}); }

  void element(std::string_view tag, Attributes attributes);
  void line(Vector from, Vector to, Attributes attributes);
  void path(std::string_view data, Attributes attributes);
  void text(Vector position, std::string_view content, const TextStyle& style);
  // Rules of CSS, for the whole document.
  void style_sheet(std::string_view rules);

  // What has this id, once more.
  void use(std::string_view id);

  // True the first time that something of this name is to be defined: ids are unique.
  bool is_new(std::string_view name) { return defined_.emplace(name).second; }

  // Ends the document.
  std::string finish() &&;

 private:
  void indent();
  void begin(std::string_view tag, Attributes attributes);

  std::string out_;
  std::set<std::string, std::less<>> defined_;
  int depth_ = 1;
};

// Path data: "x y" for use after M, L and A.
std::string coordinates(Vector position);

}  // namespace wander::figure
