// docs/glossary.md: what its last column calls "not" stands nowhere in the help texts or documents.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using Words = std::vector<std::string>;

const fs::path source = WANDER_SOURCE;

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream rest(row.substr(1));
  for (std::string cell; std::getline(rest, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

struct Glossary {
  Words terms, unwanted;
};

Glossary read_glossary(const std::string& text) {
  Glossary glossary;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| term |")) continue;
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), 6u) << line;
    glossary.terms.push_back(cells.front());
    std::istringstream unwanted(cells.back());
    for (std::string word; std::getline(unwanted >> std::ws, word, ',');)
      if (!word.empty()) glossary.unwanted.push_back(word);
  }
  return glossary;
}

// In lower case, with single blanks: a phrase may be broken over two lines.
std::string plain(const std::string& text) {
  std::string result = std::regex_replace(text, std::regex(R"(\s+)"), " ");
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

Words found_in(const std::string& text, const Words& words) {
  Words found;
  const std::string where = plain(text);
  for (const std::string& word : words)
    if (where.find(plain(word)) != std::string::npos) found.push_back(word);
  return found;
}

Glossary glossary() { return read_glossary(contents(source / "docs" / "glossary.md")); }

TEST(Glossary, HasATermOnce) {
  Words terms = glossary().terms;
  EXPECT_GT(terms.size(), 25u);
  std::ranges::sort(terms);
  EXPECT_EQ(std::ranges::adjacent_find(terms), terms.end());
}

// mutants.md quotes patches of the code.
TEST(Glossary, DocumentsUseItsWords) {
  const Words unwanted = glossary().unwanted;
  EXPECT_GT(unwanted.size(), 5u);
  EXPECT_EQ(found_in(contents(source / "README.md"), unwanted), Words{});
  for (const auto& entry : fs::directory_iterator(source / "docs")) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() != ".md" || name == "glossary.md" || name == "mutants.md")
      continue;
    EXPECT_EQ(found_in(contents(entry.path()), unwanted), Words{}) << name;
  }
}

TEST(Glossary, ControlsOfItsWords) {
  const Words unwanted{"film coordinate"};
  EXPECT_EQ(found_in("the Film\n  coordinate of a path", unwanted).size(), 1u);
  EXPECT_EQ(found_in("the position on the sensor", unwanted).size(), 0u);
}

class Helps : public CommandLine {};

TEST_F(Helps, UseTheWordsOfTheGlossary) {
  const Words unwanted = glossary().unwanted;
  for (const char* verb :
       {"", "render", "trace", "compare", "check", "plot", "inspect", "gallery", "merge", "import"})
    EXPECT_EQ(found_in(wander(std::string(verb) + " --help").out, unwanted), Words{}) << verb;
}

// Titles and labels of figures stand in the sources as they are drawn; literals may be broken.
TEST(Glossary, FiguresUseItsWords) {
  const Words unwanted = glossary().unwanted;
  for (const char* folder : {"figure", "report"})
    for (const auto& entry : fs::directory_iterator(source / "draw" / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string joined =
          std::regex_replace(contents(entry.path()), std::regex(R"("\s*")"), "");
      EXPECT_EQ(found_in(joined, unwanted), Words{}) << entry.path();
    }
}

}  // namespace
}  // namespace wander::test
