#include "scenes/format/json_document.h"

#include <fmt/format.h>

#include "scenes/format/json_text.h"

namespace wander {

// RFC 6901, and safe to print.
std::string pointer_token(std::string_view key) {
  std::string token = "/";
  for (const char c : printable(key)) {
    if (c == '~')
      token += "~0";
    else if (c == '/')
      token += "~1";
    else
      token += c;
  }
  return token;
}

std::vector<JsonMember> JsonDocument::children(JsonNode node) const {
  std::vector<JsonMember> members;
  members.reserve(node->size());
  std::size_t index = node.index + 1;
  const auto add = [&](std::string_view key, const nlohmann::ordered_json& value) {
    members.push_back({key, {&value, index}});
    index += spans_[index].size;
  };
  if (node->is_array())
    for (const auto& value : *node.value) add({}, value);
  if (node->is_object())
    for (const auto& [key, value] : node->get_ref<const nlohmann::ordered_json::object_t&>())
      add(key, value);
  return members;
}

std::optional<JsonNode> JsonDocument::find(JsonNode object, std::string_view key) const {
  if (!object->is_object()) return std::nullopt;
  std::size_t index = object.index + 1;
  for (const auto& [name, value] : object->get_ref<const nlohmann::ordered_json::object_t&>()) {
    if (name == key) return JsonNode{&value, index};
    index += spans_[index].size;
  }
  return std::nullopt;
}

bool JsonDocument::holds_byte(JsonNode node, std::size_t byte) const {
  const std::size_t next = node.index + spans_[node.index].size;
  return byte >= byte_of(node) && (next == spans_.size() || byte < spans_[next].key);
}

// Down from the root, always into the child that holds the node; values are numbered in the order
// of the text, so that skipping a child is adding its size.
std::string JsonDocument::pointer_of(JsonNode node) const {
  std::string pointer;
  for (JsonNode at = root(); at.index != node.index;) {
    std::size_t i = 0, index = at.index + 1;
    const auto last = [&] { return index + spans_[index].size > node.index; };
    for (; !last(); ++i) index += spans_[index].size;
    if (at->is_object()) {
      const auto& [key, value] = at->get_ref<const nlohmann::ordered_json::object_t&>().begin()[i];
      pointer += pointer_token(key);
      at = {&value, index};
    } else {
      pointer += fmt::format("/{}", i);
      at = {&(*at.value)[i], index};
    }
  }
  return pointer.empty() ? "/" : pointer;
}

std::string JsonDocument::shown(JsonNode node) const {
  if (node->is_array()) return "a list";
  if (node->is_object()) return "an object";
  return excerpt(token_after(text_, byte_of(node)).in(text_));
}

JsonFault JsonDocument::fault(JsonNode node, std::string what) const {
  return {byte_of(node), pointer_of(node), std::move(what)};
}

JsonFault JsonDocument::key_fault(JsonNode member, std::string what) const {
  return {spans_[member.index].key, pointer_of(member), std::move(what)};
}

}  // namespace wander
