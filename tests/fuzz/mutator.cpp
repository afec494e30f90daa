#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace wander::fuzz {

namespace {

using namespace std::string_view_literals;

// What readers stumble over: numbers at their ends, brackets, words of the formats, bytes that are no text.
constexpr std::array tokens{"-1"sv,
                            "0"sv,
                            "1e999"sv,
                            "-1e-320"sv,
                            "0.1"sv,
                            "nan"sv,
                            "null"sv,
                            "true"sv,
                            "\"\""sv,
                            "[]"sv,
                            "{}"sv,
                            "[[[["sv,
                            "\"a\":"sv,
                            "4294967296"sv,
                            "-2147483648"sv,
                            "18446744073709551615"sv,
                            "\n"sv,
                            "\r\n"sv,
                            "\0"sv,
                            "\xff"sv,
                            "\xc3\x28"sv,
                            "\xff\xff\xff\x7f"sv,
                            "\xff\xff\xff\xff\xff\xff\xff\xff"sv,
                            "/* "sv,
                            "<"sv,
                            "/>"sv,
                            "&#0;"sv,
                            "$w"sv,
                            "f -1 -1 -1\n"sv,
                            "property list uint uint x\n"sv,
                            "group paths\n"sv,
                            "dimension draw 4294967295\n"sv};

class Mutation {
 public:
  Mutation(const std::vector<std::string>& files, test::Generator& generator)
      : files_(files), generator_(generator), bytes_(files[below(files.size())]) {}

  std::string result() && {
    for (std::size_t left = 1 + below(4); left > 0; --left) change();
    return std::move(bytes_);
  }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(generator_.uniform() * static_cast<double>(count));
  }
  std::size_t place() { return below(bytes_.size() + 1); }
  // Of as many bytes as there are, but mostly few.
  std::size_t length() { return 1 + below(std::size_t{1} << below(8)); }

  void change() {
    switch (below(7)) {
      case 0:
        return flip();
      case 1:
        return bytes_.resize(place());
      case 2:
        return erase();
      case 3:
        bytes_.insert(place(), piece_of(bytes_));
        return;
      case 4:
        bytes_.insert(place(), piece_of(files_[below(files_.size())]));
        return;
      case 5:
        bytes_.insert(place(), tokens[below(tokens.size())]);
        return;
      default:
        return replace_word();
    }
  }

  void flip() {
    if (bytes_.empty()) return;
    char& byte = bytes_[below(bytes_.size())];
    byte = static_cast<char>(byte ^ (1 << below(8)));
  }
  void erase() {
    const std::size_t from = place();
    bytes_.erase(from, length());
  }
  std::string piece_of(const std::string& file) {
    const std::size_t from = below(file.size() + 1);
    return file.substr(from, length());
  }
  // A number or a word of the text.
  void replace_word() {
    const auto is_of_word = [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '_';
    };
    const auto at = bytes_.begin() + static_cast<std::ptrdiff_t>(place());
    const auto begin = std::find_if(at, bytes_.end(), is_of_word);
    const auto end = std::find_if_not(begin, bytes_.end(), is_of_word);
    const std::string_view token = tokens[below(tokens.size())];
    bytes_.replace(begin, end, token.begin(), token.end());
  }

  const std::vector<std::string>& files_;
  test::Generator& generator_;
  std::string bytes_;
};

}  // namespace

std::string mutated(const std::vector<std::string>& files, test::Generator& generator) {
  return Mutation(files, generator).result();
}

}  // namespace wander::fuzz
