// No input does harm: what is too large is refused, and mutated scenes are read or refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "scenes/format/json_explain.h"
#include "scenes/format/scene_file_schema.h"
#include "tests/scenes/format/space_texts.h"
#include "tests/support/schema_verdict.h"

namespace wander {
namespace {

TEST(SceneLimits, MayNestAtMost32Deep) {
  for (const std::string bracket : {"[", "{\"a\":"}) {
    std::string text;
    for (int i = 0; i < 1'000'000; ++i) text += bracket;
    const std::vector<Fault> faults = faults_of(text);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].column, 32 * static_cast<int>(bracket.size()) + 1);
    EXPECT_NE(faults[0].what.find("nested 32 deep"), std::string::npos);
  }
}

TEST(SceneLimits, MayHaveAMillionShapesAndNoMore) {
  std::string numbers = "1";
  for (int i = 0; i < 1'000'000; ++i) numbers += ",1";
  const std::vector<Fault> faults = faults_of(shapes_only("[" + numbers + "]"));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].pointer, "/shapes/1000000");
}

TEST(SceneLimits, MayHave64MebibytesAndNoMore) {
  const std::vector<Fault> faults = faults_of(std::string((std::size_t{64} << 20) + 1, ' '));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].what.find("64 MiB"), std::string::npos);
}

// Replaces, inserts, removes, repeats and swaps bytes, some of which mean something in JSON.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> parts{
      "\"",   "{",     "}",    "[",       "]",  ",", ":", "-",     "1e999", "NaN",
      "null", "//",    "/*",   "\\u0000", "\n", "0", "1", "\\",    "\xFF",  "2.5",
      "-1",   "\"x\"", "true", "{}",      "[]", "3", ".", "1e-400"};
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
    const std::size_t at = below(text.size()), length = std::min(below(12), text.size() - at);
    switch (below(4)) {
      case 0:
        text.replace(at, length, parts[below(parts.size())]);
        break;
      case 1:
        text.insert(at, parts[below(parts.size())]);
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      default:
        text[at] = static_cast<char>(below(256));
    }
  }
  return text;
}

TEST(SceneLimits, MutatedByBytesIsReadOrRefusedWithPlaces) {
  std::mt19937 random(1);
  int valid = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutated(everything, random);
    try {
      parse(text);
      ++valid;
    } catch (const SceneFileError& error) {
      ASSERT_FALSE(error.faults.empty());
      const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
      for (const Fault& fault : error.faults) {
        ASSERT_TRUE(fault.line >= 1 && fault.line <= lines && fault.column >= 1) << text;
        ASSERT_TRUE(fault.pointer.starts_with('/') && !fault.what.empty()) << text;
        ASSERT_EQ(fault.what.find('\n'), std::string::npos) << text;
      }
    }
  }
  EXPECT_GT(valid, 20);  // mutations within comments and names, if nothing else
}

TEST(SceneSchema, IsExplainedExactlyWhereItIsViolated) {
  const auto schema = nlohmann::ordered_json::parse(scene_schema_text);
  std::mt19937 random(2);
  int violated = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutated(i < 1000 ? everything : everything_in_space, random);
    const JsonReading reading = read_json(text);
    if (!reading.document || !reading.faults.empty()) continue;
    const Explanation why = explain(*reading.document, schema);
    ASSERT_EQ(why.faults.empty(), test::conforms(*reading.document, scene_schema_text)) << text;
    if (!why.faults.empty()) ++violated;
  }
  EXPECT_GT(violated, 100);
}

// Keywords that the walk does not know: it would let pass what they forbid.
void add_unknown_keywords(const nlohmann::json& schema, std::set<std::string>& unknown) {
  static const std::set<std::string> alone{
      "$schema",  "$comment", "$ref",      "title",     "description",     "type",
      "required", "const",    "enum",      "minimum",   "maximum",         "exclusiveMinimum",
      "minItems", "maxItems", "minLength", "maxLength", "exclusiveMaximum"};
  static const std::set<std::string> of_a_schema{
      "if", "then", "else", "not", "items", "contains", "additionalProperties"};
  if (!schema.is_object()) return;
  for (const auto& [keyword, value] : schema.items()) {
    if (of_a_schema.contains(keyword))
      add_unknown_keywords(value, unknown);
    else if (keyword == "properties" || keyword == "definitions" || keyword == "allOf")
      for (const auto& part : value) add_unknown_keywords(part, unknown);
    else if (!alone.contains(keyword))
      unknown.insert(keyword);
  }
}

TEST(SceneSchema, HasNoKeywordThatTheWalkDoesNotKnow) {
  const auto unknown_in = [](const char* text) {
    std::set<std::string> unknown;
    add_unknown_keywords(nlohmann::json::parse(text), unknown);
    return unknown;
  };
  EXPECT_EQ(unknown_in(scene_schema_text), std::set<std::string>{});
  EXPECT_EQ(unknown_in(R"({"properties": {"pattern": {"pattern": "x"}}, "oneOf": []})"),
            (std::set<std::string>{"oneOf", "pattern"}));
}

// valijson is here to agree with: in the program it would judge every scene a second time.
TEST(SceneSchema, IsJudgedOnce) {
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(WANDER_SOURCE) / "scenes/format")) {
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    EXPECT_EQ(text.find("#include <valijson"), std::string::npos) << entry.path();
  }
}

}  // namespace
}  // namespace wander
