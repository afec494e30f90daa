// A JSON document that remembers where in its text each value stands, and all that is wrong with it
// as JSON.  Safe for any text: what could exhaust memory or stack is refused while it is read.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace wander {

struct JsonLimits {
  std::size_t depth = 32;        // of nested lists and objects
  std::size_t string = 4096;     // bytes of a text or a key
  std::size_t list = 1'000'000;  // elements
  std::size_t object = 100'000;  // keys
  std::size_t faults = 100;      // that are told; one more is looked for, to say so
};
inline constexpr JsonLimits json_limits;

struct JsonFault {
  std::size_t byte = 0;
  std::string pointer, what;

  auto operator<=>(const JsonFault&) const = default;
};

// A value with its number in the order of the text.
struct JsonNode {
  const nlohmann::ordered_json* value = nullptr;
  std::size_t index = 0;

  const nlohmann::ordered_json* operator->() const { return value; }
};

struct JsonMember {
  std::string_view key;  // empty in a list
  JsonNode node;
};

class JsonDocument {
 public:
  // Where a value, and its key if it has one, begin; `size` counts it with all values inside.
  struct Span {
    std::uint32_t key = 0, value = 0, size = 1;
  };

  JsonDocument(std::string_view text, nlohmann::ordered_json root, std::vector<Span> spans,
               std::set<std::size_t> spoiled)
      : text_(text),
        root_(std::move(root)),
        spans_(std::move(spans)),
        spoiled_(std::move(spoiled)) {}

  JsonNode root() const { return {&root_, 0}; }
  std::vector<JsonMember> children(JsonNode node) const;
  std::optional<JsonNode> find(JsonNode object, std::string_view key) const;

  std::size_t byte_of(JsonNode node) const { return spans_[node.index].value; }
  bool holds_byte(JsonNode node, std::size_t byte) const;
  std::string pointer_of(JsonNode node) const;
  // A number or string as it is written; "a list" and "an object" otherwise.
  std::string shown(JsonNode node) const;
  // Its value could not be kept, which is reported already.
  bool is_spoiled(JsonNode node) const { return spoiled_.contains(byte_of(node)); }

  JsonFault fault(JsonNode node, std::string what) const;
  JsonFault key_fault(JsonNode member, std::string what) const;

 private:
  std::string_view text_;
  nlohmann::ordered_json root_;
  std::vector<Span> spans_;
  std::set<std::size_t> spoiled_;
};

struct JsonReading {
  std::optional<JsonDocument> document;  // none after a fault that ends the reading
  std::vector<JsonFault> faults;
};

// Comments are allowed, duplicate keys are not.  The text outlives the document.
JsonReading read_json(std::string_view text);

std::string pointer_token(std::string_view key);

}  // namespace wander
