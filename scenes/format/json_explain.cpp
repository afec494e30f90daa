// The walk along schema and document.  Where it and valijson disagree about a document, one of them
// is wrong: a test holds them together.
#include "scenes/format/json_explain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_nearest.h"

namespace wander {

namespace {

using json = nlohmann::ordered_json;  // keys keep the order of the schema

struct Type {
  std::string_view name, words;
  bool (*holds)(const json&);
};
constexpr Type types[] = {
    {"object", "an object", [](const json& v) { return v.is_object(); }},
    {"array", "a list", [](const json& v) { return v.is_array(); }},
    {"string", "a text", [](const json& v) { return v.is_string(); }},
    {"number", "a number", [](const json& v) { return v.is_number(); }},
    {"integer", "an integer", [](const json& v) { return v.is_number_integer(); }},
    {"boolean", "true or false", [](const json& v) { return v.is_boolean(); }},
};

std::string_view words_for(std::string_view name) {
  const auto is_named = [name](const Type& type) { return type.name == name; };
  return std::find_if(std::begin(types), std::end(types), is_named)->words;
}

// A keyword of a schema, null when it is absent.
const json& keyword(const json& schema, const char* name) {
  static const json absent;
  const auto found = schema.find(name);
  return found == schema.end() ? absent : *found;
}

std::string description_in(const json& schema) { return schema.value("description", ""); }

// A bound that is absent is kept by every number.
template <class Keeps>
bool keeps(const json& schema, const char* bound, Keeps keeps_bound) {
  const json& found = keyword(schema, bound);
  return found.is_null() || keeps_bound(found.get<double>());
}

bool within_bounds(const json& schema, const json& value) {
  if (!value.is_number()) return true;
  const double x = value.get<double>();
  return keeps(schema, "minimum", [x](double b) { return x >= b; }) &&
         keeps(schema, "maximum", [x](double b) { return x <= b; }) &&
         keeps(schema, "exclusiveMinimum", [x](double b) { return x > b; }) &&
         keeps(schema, "exclusiveMaximum", [x](double b) { return x < b; });
}

bool within_sizes(const json& schema, const json& value) {
  const auto size = static_cast<double>(
      value.is_string() ? value.get_ref<const std::string&>().size() : value.size());
  const auto fits = [&](const char* fewest, const char* most) {
    return keeps(schema, fewest, [size](double b) { return size >= b; }) &&
           keeps(schema, most, [size](double b) { return size <= b; });
  };
  if (value.is_array()) return fits("minItems", "maxItems");
  return !value.is_string() || fits("minLength", "maxLength");
}

class Walk {
 public:
  Walk(const JsonDocument& document, const json& schema) : document_(document), root_(schema) {}

  Explanation of_document() && {
    visit(root_, document_.root());
    return std::move(explanation_);
  }

 private:
  void visit(const json& schema, JsonNode node);
  void visit_members(const json& schema, JsonNode object);
  void visit_conditions(const json& schema, JsonNode node);
  void note_missing(const json& schema, JsonNode object);
  void note_unknown(const json& properties, JsonMember member);
  std::string alone(const json& schema, JsonNode node) const;
  std::string choice(const json& schema, JsonNode node) const;
  bool has_type(const json& schema, JsonNode node) const;
  bool contains_wanted(const json& schema, JsonNode node) const;
  const json& resolved(const json& schema) const;
  bool matches(const json& schema, JsonNode node) const;
  bool is_full() const { return explanation_.faults.size() > json_limits.faults; }

  const JsonDocument& document_;
  const json& root_;
  mutable std::unordered_map<const json*, const json*> targets_;  // of references that were met
  Explanation explanation_;
};

// References are one step deep in the schema.
const json& Walk::resolved(const json& schema) const {
  if (!schema.is_object() || !schema.contains("$ref")) return schema;
  const auto [found, is_new] = targets_.try_emplace(&schema, nullptr);
  if (is_new)
    found->second = &root_.at(json::json_pointer(schema.at("$ref").get<std::string>().substr(1)));
  return *found->second;
}

// For the conditions of a schema, which ask for the types and constants of members.
bool Walk::matches(const json& unresolved, JsonNode node) const {
  const json& schema = resolved(unresolved);
  if (!schema.is_object()) return true;
  if (!alone(schema, node).empty()) return false;
  for (const json& name : keyword(schema, "required"))
    if (!document_.find(node, name.get_ref<const std::string&>())) return false;
  for (const auto& [key, member_schema] : keyword(schema, "properties").items())
    if (const auto member = document_.find(node, key); member && !matches(member_schema, *member))
      return false;
  return true;
}

// A word among words.
std::string Walk::choice(const json& schema, JsonNode node) const {
  const json& allowed = schema.at("enum");
  const auto equals = [&](const json& word) { return word == *node.value; };
  if (std::any_of(allowed.begin(), allowed.end(), equals)) return {};
  const bool words = std::all_of(allowed.begin(), allowed.end(),
                                 [](const json& word) { return word.is_string(); });
  if (!words)
    return fmt::format("{} is not allowed; {}", document_.shown(node), description_in(schema));
  const auto known = allowed.get<std::vector<std::string>>();
  if (!node->is_string())
    return fmt::format("{} is not a text; allowed are {}", document_.shown(node),
                       fmt::join(known, ", "));
  return fmt::format("{} is not known; {}", document_.shown(node),
                     suggestion(node->get<std::string>(), known));
}

bool Walk::has_type(const json& schema, JsonNode node) const {
  const json& name = keyword(schema, "type");
  return name.is_null() || std::none_of(std::begin(types), std::end(types), [&](const Type& type) {
           return type.name == name && !type.holds(*node.value);
         });
}

bool Walk::contains_wanted(const json& schema, JsonNode node) const {
  const json& wanted = keyword(schema, "contains");
  if (wanted.is_null() || !node->is_array()) return true;
  const auto members = document_.children(node);
  return std::any_of(members.begin(), members.end(),
                     [&](const JsonMember& member) { return matches(wanted, member.node); });
}

// What is wrong with the value itself, whatever it holds; empty when nothing is.
std::string Walk::alone(const json& schema, JsonNode node) const {
  if (schema.contains("not")) return description_in(schema);
  if (!has_type(schema, node))
    return fmt::format("{} is not {}; {}", document_.shown(node),
                       words_for(schema.at("type").get_ref<const std::string&>()),
                       description_in(schema));
  if (schema.contains("enum")) return choice(schema, node);
  const json& constant = keyword(schema, "const");
  const bool is_constant = constant.is_null() || constant == *node.value;
  if (!is_constant || !within_bounds(schema, *node.value))
    return fmt::format("{} is not allowed; {}", document_.shown(node), description_in(schema));
  if (within_sizes(schema, *node.value) && contains_wanted(schema, node)) return {};
  const std::string shown =
      node->is_array() ? fmt::format("a list of {}", node->size()) : document_.shown(node);
  return fmt::format("{} is not allowed; {}", shown, description_in(schema));
}

void Walk::note_missing(const json& schema, JsonNode object) {
  for (const json& name : keyword(schema, "required")) {
    const auto key = name.get<std::string>();
    if (document_.find(object, key)) continue;
    const json& wanted = resolved(schema.at("properties").at(key));
    const std::string description = wanted.is_object() ? description_in(wanted) : "";
    explanation_.faults.push_back(
        document_.fault(object, fmt::format("\"{}\" is missing; {}", key, description)));
  }
}

void Walk::note_unknown(const json& properties, JsonMember member) {
  std::vector<std::string> known;
  for (const auto& [key, schema] : properties.items()) known.push_back(key);
  explanation_.meant.insert(likely_word(member.key, known));
  explanation_.faults.push_back(document_.key_fault(
      member.node,
      fmt::format("unknown key \"{}\"; {}", excerpt(member.key), suggestion(member.key, known))));
}

void Walk::visit_members(const json& schema, JsonNode object) {
  note_missing(schema, object);
  const json& properties = keyword(schema, "properties");
  const json& others = keyword(schema, "additionalProperties");
  for (const JsonMember& member : document_.children(object)) {
    if (is_full()) return;
    const auto found = properties.find(member.key);
    if (found != properties.end())
      visit(*found, member.node);
    else if (others == false)
      note_unknown(properties, member);
    else
      visit(others, member.node);
  }
}

void Walk::visit_conditions(const json& schema, JsonNode node) {
  for (const json& part : keyword(schema, "allOf")) visit(part, node);
  if (!schema.contains("if")) return;
  const char* branch = matches(schema.at("if"), node) ? "then" : "else";
  visit(keyword(schema, branch), node);
}

// A value that is wrong by itself is not looked into: of a list that should be a number, no element
// is worth a message.
void Walk::visit(const json& unresolved, JsonNode node) {
  const json& schema = resolved(unresolved);
  if (!schema.is_object() || document_.is_spoiled(node) || is_full()) return;
  if (std::string what = alone(schema, node); !what.empty()) {
    explanation_.faults.push_back(document_.fault(node, std::move(what)));
    return;
  }
  if (node->is_object()) visit_members(schema, node);
  if (node->is_array() && schema.contains("items"))
    for (const JsonMember& member : document_.children(node)) {
      if (is_full()) return;
      visit(schema.at("items"), member.node);
    }
  visit_conditions(schema, node);
}

}  // namespace

Explanation explain(const JsonDocument& document, const json& schema) {
  return Walk(document, schema).of_document();
}

}  // namespace wander
