// Reading of text into a JsonDocument: nlohmann's parser judges the grammar and decodes; the tokens
// that are scanned in step with it tell the places.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <unordered_set>

#include "scenes/format/json_document.h"
#include "scenes/format/json_text.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

bool is_not_a_number(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  return word == "NaN" || word == "nan" || word == "Infinity" || word == "inf" || word == "Inf" ||
         word == "infinity" || word == "NAN" || word == "INF";
}

// Too large, not too small: 1e-999 is a good zero.
bool overflows(std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc::result_out_of_range && end == word.data() + word.size() &&
         ordered_json::parse(word, nullptr, false).is_discarded();
}

// Numbers without a finite value end nlohmann's reading, and they are but one fault of many: they
// are read as 0, and known by their place.
struct FiniteText {
  std::string copy;  // empty while the text is good as it is
  std::set<std::size_t> places;
};

FiniteText with_finite_numbers(std::string_view text) {
  FiniteText result;
  for (Token token = token_after(text, 0); !token.empty(); token = token_after(text, token.end)) {
    const std::string_view word = token.in(text);
    if (!is_not_a_number(word) && !overflows(word)) continue;
    if (result.copy.empty()) result.copy = text;
    result.copy.replace(token.begin, word.size(), word.size(), ' ');
    result.copy[token.begin] = '0';
    result.places.insert(token.begin);
  }
  return result;
}

// From nlohmann's "... - unexpected X; expected Y" or "... - problem; last read: 'token'" to words
// about the token as it is written.
std::string syntax_message(std::string what, std::string_view token) {
  constexpr std::pair<std::string_view, std::string_view> expectations[] = {
      {"'[', '{', or a literal", "a value"},
      {"'}'", "',' or '}'"},
      {"']'", "',' or ']'"},
      {"string literal", "a key in double quotes"},
      {"end of input", "the end, for a scene is one object"},
  };
  constexpr std::string_view expected = "; expected ", unexpected = "unexpected ";
  if (what.find("control character U+000A") != std::string::npos)
    return "the text does not end on its line; a closing \" is missing";
  const std::string shown = token.empty() ? "the end of the file" : excerpt(token);
  // Of 1e999x nlohmann sees 1e999 first.
  if (what.find("invalid literal") != std::string::npos ||
      what.find("number overflow") != std::string::npos)
    return fmt::format(
        "{} is no JSON; a value is a number, \"text\", true, false, [...] or {{...}}", shown);
  if (const auto dash = what.find(" - "); dash != std::string::npos) what.erase(0, dash + 3);
  if (const auto last = what.find("; last read: "); last != std::string::npos) what.erase(last);
  const auto at = what.find(expected);
  if (!what.starts_with(unexpected) || at == std::string::npos) return what;
  std::string_view wanted = std::string_view(what).substr(at + expected.size());
  for (const auto& [theirs, ours] : expectations)
    if (wanted == theirs) {
      wanted = ours;
      break;
    }
  return fmt::format("{} is not allowed here; expected is {}", shown, wanted);
}

// Receives the events of nlohmann's parser.
class Builder {
 public:
  Builder(std::string_view text, std::string_view original, const std::set<std::size_t>& not_finite)
      : text_(text), original_(original), not_finite_(not_finite) {}

  bool null() { return scalar(next(), nullptr); }
  bool boolean(bool value) { return scalar(next(), value); }
  bool number_integer(std::int64_t value) { return number(next(), static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return number(next(), static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return number(next(), value); }
  bool string(std::string& value) { return text(next(), value); }
  bool binary(ordered_json::binary_t&) { return false; }
  bool start_object(std::size_t) { return start(next(), ordered_json::object()); }
  bool start_array(std::size_t) { return start(next(), ordered_json::array()); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool key(std::string& name);
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::json::exception& error);

  JsonReading result() &&;

 private:
  struct Frame {
    ordered_json value;
    std::size_t span;
    std::string key;  // of the member that is being read
    std::unordered_set<std::string> keys;
  };

  Token next();
  bool number(Token token, double value);
  bool text(Token token, std::string& value);
  bool scalar(Token token, ordered_json value);
  bool start(Token token, ordered_json empty);
  bool end();
  bool may_begin(Token token);
  void add(ordered_json value);
  bool end_reading(std::size_t byte, std::string what);
  void note(std::size_t byte, std::string what);
  std::string pointer() const;

  std::string_view text_, original_;  // the one that is read, the one that was written
  const std::set<std::size_t>& not_finite_;
  Token token_;               // the last one that the parser has taken
  std::size_t key_byte_ = 0;  // of the member that is being read
  bool skips_next_ = false;   // the value of a key that was not kept
  std::size_t skipped_depth_ = 0;
  std::vector<Frame> frames_;
  ordered_json root_;
  std::vector<JsonDocument::Span> spans_;
  std::set<std::size_t> spoiled_;
  std::vector<JsonFault> faults_;
  bool complete_ = true;
};

Token Builder::next() {
  do token_ = token_after(text_, token_.end);
  while (token_.in(text_) == "," || token_.in(text_) == ":");
  return token_;
}

std::string Builder::pointer() const {
  std::string path;
  for (const Frame& frame : frames_) {
    if (frame.value.is_array())
      path += fmt::format("/{}", frame.value.size());
    else if (!frame.key.empty())
      path += pointer_token(frame.key);
  }
  return path.empty() ? "/" : path;
}

void Builder::note(std::size_t byte, std::string what) {
  if (faults_.size() <= json_limits.faults) faults_.push_back({byte, pointer(), std::move(what)});
}

bool Builder::end_reading(std::size_t byte, std::string what) {
  faults_.push_back({byte, pointer(), std::move(what)});
  complete_ = false;
  return false;
}

void Builder::add(ordered_json value) {
  if (frames_.empty()) {
    root_ = std::move(value);
    return;
  }
  Frame& frame = frames_.back();
  if (frame.value.is_array()) {
    frame.value.push_back(std::move(value));
    return;
  }
  // ordered_json's own insertion would look through all keys again.
  frame.value.get_ref<ordered_json::object_t&>().emplace_back(frame.key, std::move(value));
  frame.key.clear();
}

// Enters the value in the order of the text, unless the list it stands in is full.
bool Builder::may_begin(Token token) {
  auto key = token.begin;
  if (!frames_.empty() && frames_.back().value.is_object()) key = key_byte_;
  if (!frames_.empty() && frames_.back().value.is_array() &&
      frames_.back().value.size() >= json_limits.list)
    return end_reading(token.begin, fmt::format("the list is too long; it may have {} elements",
                                                json_limits.list));
  spans_.push_back({static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(token.begin), 1});
  return true;
}

bool Builder::scalar(Token token, ordered_json value) {
  if (skipped_depth_ > 0 || std::exchange(skips_next_, false)) return true;
  if (!may_begin(token)) return false;
  add(std::move(value));
  return true;
}

bool Builder::number(Token token, double value) {
  if (not_finite_.contains(token.begin)) {
    const Token written = token_after(original_, token.begin);
    note(token.begin, fmt::format("{} is not a finite number; numbers are finite, below 1.8e308",
                                  excerpt(written.in(original_))));
    spoiled_.insert(token.begin);
  }
  // In any locale; what lies below the smallest double stays as nlohmann rounds it.
  const std::string_view word = token.in(text_);
  std::from_chars(word.data(), word.data() + word.size(), value);
  constexpr double exact_below = 9007199254740992;  // 2^53
  // As JSON Schema has it, 100.0 is an integer.
  if (std::abs(value) < exact_below && value == std::trunc(value))
    return scalar(token, static_cast<std::int64_t>(value));
  return scalar(token, value);
}

bool Builder::text(Token token, std::string& value) {
  if (value.size() <= json_limits.string) return scalar(token, std::move(value));
  note(token.begin,
       fmt::format("the text has {} bytes; a text may have {}", value.size(), json_limits.string));
  spoiled_.insert(token.begin);
  return scalar(token, "");
}

bool Builder::key(std::string& name) {
  const Token token = next();
  if (skipped_depth_ > 0) return true;
  Frame& frame = frames_.back();
  key_byte_ = token.begin;
  frame.key.clear();
  if (name.size() > json_limits.string) {
    note(token.begin,
         fmt::format("the key has {} bytes; a key may have {}", name.size(), json_limits.string));
    return skips_next_ = true;
  }
  frame.key = name;
  if (frame.keys.size() >= json_limits.object)
    return end_reading(token.begin,
                       fmt::format("too many keys; an object may have {}", json_limits.object));
  if (frame.keys.insert(std::move(name)).second) return true;
  note(token.begin,
       fmt::format("the key \"{}\" appears twice; remove one of the two", excerpt(frame.key)));
  return skips_next_ = true;
}

bool Builder::start(Token token, ordered_json empty) {
  if (skipped_depth_ > 0 || std::exchange(skips_next_, false)) {
    ++skipped_depth_;
    return true;
  }
  if (frames_.size() >= json_limits.depth)
    return end_reading(token.begin,
                       fmt::format("nested too deeply; lists and objects may be nested "
                                   "{} deep",
                                   json_limits.depth));
  if (!may_begin(token)) return false;
  frames_.push_back({std::move(empty), spans_.size() - 1, {}, {}});
  return true;
}

bool Builder::end() {
  next();
  if (skipped_depth_ > 0) {
    --skipped_depth_;
    return true;
  }
  Frame frame = std::move(frames_.back());
  frames_.pop_back();
  spans_[frame.span].size = static_cast<std::uint32_t>(spans_.size() - frame.span);
  add(std::move(frame.value));
  return true;
}

// `position` is the byte after what the grammar does not allow: the next token but commas and
// colons, or a part of the last one, such as the 1 in 01.
bool Builder::parse_error(std::size_t position, const std::string&,
                          const nlohmann::json::exception& error) {
  Token token = token_;
  if (token.empty() || position > token.end) {
    const auto is_separator = [&] { return token.in(text_) == "," || token.in(text_) == ":"; };
    token = token_after(text_, token.end);
    while (is_separator() && token.end < position) token = token_after(text_, token.end);
  }
  return end_reading(token.begin, syntax_message(error.what(), token.in(text_)));
}

JsonReading Builder::result() && {
  JsonReading reading{std::nullopt, std::move(faults_)};
  if (complete_)
    reading.document.emplace(original_, std::move(root_), std::move(spans_), std::move(spoiled_));
  return reading;
}

}  // namespace

JsonReading read_json(std::string_view text) {
  if (const auto bad = first_bad_byte(text))
    return {std::nullopt,
            {{*bad, "/",
              fmt::format("the byte 0x{:02X} is not allowed here; a scene is text in UTF-8",
                          static_cast<unsigned char>(text[*bad]))}}};
  const FiniteText finite = with_finite_numbers(text);
  const std::string_view readable = finite.copy.empty() ? text : finite.copy;
  Builder builder(readable, text, finite.places);
  constexpr bool strict = true, ignore_comments = true;
  ordered_json::sax_parse(readable, &builder, ordered_json::input_format_t::json, strict,
                          ignore_comments);
  return std::move(builder).result();
}

}  // namespace wander
