#include "draw/figure/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

// One character of UTF-8; `bytes` is 1 where the text is not UTF-8.
struct Character {
  std::size_t bytes = 1;
  bool valid = false;
};

std::size_t length_by_first_byte(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

// The character range of XML 1.0, section 2.2.
bool xml_allows(std::uint32_t code) {
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return !surrogate && code != 0xFFFE && code != 0xFFFF && code <= 0x10FFFF;
}

Character next_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint8_t>(text[k]); };
  const std::size_t bytes = length_by_first_byte(byte(0));
  if (bytes == 0 || bytes > text.size()) return {};
  if (bytes == 1) return {1, xml_allows(byte(0))};

  std::uint32_t code = byte(0) & (0x7Fu >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xC0u) != 0x80u) return {};
    code = (code << 6) | (byte(k) & 0x3Fu);
  }
  const bool overlong = (bytes == 3 && code < 0x800) || (bytes == 4 && code < 0x10000);
  if (overlong) return {};
  return {bytes, xml_allows(code)};
}

// In ems, after DejaVu Sans, the widest of the common sans-serif faces.
double character_width(std::string_view character) {
  if (character.size() > 2) return 0.85;
  if (character.size() == 2) return 0.6;
  const char c = character[0];
  if (std::string_view("ijl'|").find(c) != std::string_view::npos) return 0.3;
  if (std::string_view(" .,:;()[]/fIrt-").find(c) != std::string_view::npos) return 0.38;
  if (std::string_view("mwMW%@").find(c) != std::string_view::npos) return 0.95;
  if (c >= 'A' && c <= 'Z') return 0.7;
  return 0.62;
}

}  // namespace

std::string number(double value) {
  if (!std::isfinite(value)) return "0";
  std::string digits = fmt::format("{:.2f}", value);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character next = next_character(text);
    const std::string_view character = text.substr(0, next.bytes);
    text.remove_prefix(next.bytes);
    if (!next.valid)
      result += replacement;
    else if (character == "<")
      result += "&lt;";
    else if (character == ">")
      result += "&gt;";
    else if (character == "&")
      result += "&amp;";
    else if (character == "\"")
      result += "&quot;";
    else
      result += character;
  }
  return result;
}

double text_width(std::string_view text, double font_size) {
  double ems = 0;
  while (!text.empty()) {
    const std::size_t bytes = next_character(text).bytes;
    ems += character_width(text.substr(0, bytes));
    text.remove_prefix(bytes);
  }
  return ems * font_size;
}

// In the middle, for names that begin alike often differ at their ends.
std::string shortened(std::string_view text, double font_size, double width) {
  if (text_width(text, font_size) <= width) return std::string(text);
  constexpr std::string_view ellipsis = "…";
  std::vector<std::string_view> characters;
  while (!text.empty()) {
    characters.push_back(text.substr(0, next_character(text).bytes));
    text.remove_prefix(characters.back().size());
  }
  double left = width - text_width(ellipsis, font_size);
  std::string head, tail;
  for (std::size_t k = 0; k < characters.size(); ++k) {
    const bool is_of_head = k % 2 == 0;
    const std::string_view next =
        is_of_head ? characters[k / 2] : characters[characters.size() - 1 - k / 2];
    left -= text_width(next, font_size);
    if (left < 0) break;
    is_of_head ? head += next : tail.insert(0, next);
  }
  return head + std::string(ellipsis) + tail;
}

std::vector<std::string> wrapped(std::string_view text, double font_size, double width) {
  std::vector<std::string> lines{""};
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (line.empty() || text_width(longer, font_size) <= width)
      line = longer;
    else
      lines.push_back(word);
  }
  for (std::string& line : lines) line = shortened(line, font_size, width);
  return lines;
}

std::string coordinates(Vector position) { return number(position.x) + ' ' + number(position.y); }

Svg::Svg(Vector size, std::string_view title, std::string_view description) {
  out_ = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0}pt\" height=\"{1}pt\" "
      "viewBox=\"0 0 {0} {1}\" role=\"img\" font-family=\"{2}\">\n",
      number(size.x), number(size.y), style::font);
  out_ +=
      fmt::format("  <title>{}</title>\n  <desc>{}</desc>\n", escaped(title), escaped(description));
  element("rect", {{"width", size.x}, {"height", size.y}, {"fill", style::paper}});
}

Svg::Scope::~Scope() {
  --svg_.depth_;
  svg_.indent();
  svg_.out_ += "</" + tag_ + ">\n";
}

Svg::Scope Svg::open(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  out_ += ">\n";
  ++depth_;
  return {*this, tag};
}

void Svg::element(std::string_view tag, Attributes attributes) {
  begin(tag, attributes);
  out_ += "/>\n";
}

void Svg::line(Vector from, Vector to, Attributes attributes) {
  path("M" + coordinates(from) + "L" + coordinates(to), attributes);
}

void Svg::path(std::string_view data, Attributes attributes) {
  begin("path", attributes);
  out_ += fmt::format(" d=\"{}\"/>\n", data);
}

void Svg::text(Vector position, std::string_view content, const TextStyle& text_style) {
  indent();
  out_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\"", number(position.x),
                      number(position.y), number(text_style.size), style::ink);
  if (text_style.anchor != "start") out_ += fmt::format(" text-anchor=\"{}\"", text_style.anchor);
  if (text_style.weight != "normal") out_ += fmt::format(" font-weight=\"{}\"", text_style.weight);
  if (text_style.rotation != 0)
    out_ += fmt::format(" transform=\"rotate({} {})\"", number(text_style.rotation),
                        coordinates(position));
  out_ += fmt::format(">{}</text>\n", escaped(content));
}

// SVG 2 has href, SVG 1.1 xlink:href; Inkscape 1.2 knows the latter alone.
void Svg::use(std::string_view id) {
  const std::string reference = fmt::format("#{}", id);
  element("use", {{"href", reference}, {"xlink:href", reference}});
}

void Svg::style_sheet(std::string_view rules) {
  indent();
  out_ += fmt::format("<style>{}</style>\n", escaped(rules));
}

std::string Svg::finish() && { return std::move(out_) + "</svg>\n"; }

void Svg::indent() { out_.append(static_cast<std::size_t>(2 * depth_), ' '); }

void Svg::begin(std::string_view tag, Attributes attributes) {
  indent();
  out_ += fmt::format("<{}", tag);
  for (const Attribute& attribute : attributes)
    out_ += fmt::format(" {}=\"{}\"", attribute.name, escaped(attribute.value));
}

}  // namespace wander::figure
