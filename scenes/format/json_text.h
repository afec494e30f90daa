// The text of a JSON document below its grammar: tokens, encoding, and the place of a byte.
//
// The parser tells what it read but not where.  Tokens read here, in step with the parser, tell
// where: this scanner never fails, and whether the tokens make sense is left to the parser.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace wander {

struct Token {
  std::size_t begin = 0, end = 0;  // bytes [begin, end) of the text; empty at its end

  std::string_view in(std::string_view text) const { return text.substr(begin, end - begin); }
  bool empty() const { return begin == end; }
};

// The first token at or after a byte, past white space and comments: a string with its quotes, a
// number or word, or a single character.
Token token_after(std::string_view text, std::size_t begin);

// The first byte that is not UTF-8 or is NUL.
std::optional<std::size_t> first_bad_byte(std::string_view text);

struct LineColumn {
  int line = 1, column = 1;
};

// Places of bytes; linear in the text altogether when they are asked for in their order.
class Places {
 public:
  explicit Places(std::string_view text) : text_(text) {}
  LineColumn of(std::size_t byte);

 private:
  std::string_view text_;
  std::size_t byte_ = 0;
  LineColumn place_;
};

// As a message shows it: on one line, in UTF-8, without control characters, at most about 60 characters.
std::string excerpt(std::string_view text);
// Whole, in UTF-8, without control characters.
std::string printable(std::string_view text);

}  // namespace wander
