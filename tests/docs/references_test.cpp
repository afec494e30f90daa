// docs/references.md lists every work that code and documents cite in brackets, as in [Veach 1997], and no work that nobody
// names.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tools/command_line.h"

namespace wander::test::references {
namespace {

using Citations = std::set<std::string>;

// Comments are broken over lines.
std::string in_one_line(const std::string& text) {
  std::string joined;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (word != "//" && word != "#" && word != "*") joined += word + " ";
  return joined;
}

bool is_year(const std::string& word) {
  return word.size() == 4 &&
         (word.starts_with("18") || word.starts_with("19") || word.starts_with("20")) &&
         std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c); });
}

bool belongs_to_a_name(const std::string& word) {
  static const std::set<std::string> between{"and", "et", "al.", "van", "der"};
  const auto first = static_cast<unsigned char>(word.front());
  const bool is_capital = std::isupper(first) || first >= 0x80;  // or a letter with an accent
  return between.contains(word) || (is_capital && word.find_first_of(":;()") == std::string::npos);
}

// Who is cited in the text between two brackets: the names before each year.
Citations cited_between(const std::string& brackets) {
  Citations found;
  std::vector<std::string> words;
  std::istringstream rest(brackets);
  for (std::string word; rest >> word;) {
    const std::string bare = word.substr(0, word.find_last_not_of(",;.:") + 1);
    if (!is_year(bare)) {
      words.push_back(word);
      continue;
    }
    std::string name;
    while (!words.empty() && belongs_to_a_name(words.back())) {
      name = words.back() + " " + name;
      words.pop_back();
    }
    if (!name.empty()) found.insert(name + bare);
    words.clear();
  }
  return found;
}

Citations cited_in(const std::string& text) {
  constexpr std::size_t longest = 200;
  Citations found;
  const std::string line = in_one_line(text);
  for (std::size_t open = line.find('['); open != std::string::npos;
       open = line.find('[', open + 1)) {
    const std::size_t close = line.find_first_of("[]", open + 1);
    if (close == std::string::npos || line[close] != ']' || close - open > longest) continue;
    found.merge(cited_between(line.substr(open + 1, close - open - 1)));
  }
  return found;
}

const fs::path source = WANDER_SOURCE;

Citations listed() {
  Citations found;
  std::istringstream lines(contents(source / "docs" / "references.md"));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("* **")) {
      EXPECT_TRUE(found.insert(line.substr(4, line.find(".**") - 4)).second)
          << line << " stands twice";
    }
  return found;
}

// Scripts have no ending.
bool is_source_or_document(const fs::path& file) {
  static const std::set<std::string> endings{".h", ".cpp", ".md", ".py", ""};
  return endings.contains(file.extension()) && file.filename() != "references.md" &&
         file.filename() != "references_test.cpp";
}

std::vector<fs::path> sources_and_documents() {
  std::vector<fs::path> files{source / "README.md"};
  for (const char* room : {"core", "docs", "draw", "lab", "mlt", "mutations", "python", "records",
                           "scenes", "statistics", "tests", "tools", "work"})
    for (const auto& entry : fs::recursive_directory_iterator(source / room))
      if (entry.is_regular_file() && is_source_or_document(entry.path()))
        files.push_back(entry.path());
  return files;
}

TEST(References, ListAllThatIsCitedAndNothingElse) {
  const Citations works = listed();
  EXPECT_GT(works.size(), 50u);
  std::string all;
  std::size_t cited = 0;
  for (const fs::path& file : sources_and_documents()) {
    const std::string text = contents(file);
    all += text;
    for (const std::string& name : cited_in(text)) {
      ++cited;
      EXPECT_TRUE(works.contains(name)) << file << " cites " << name;
    }
  }
  EXPECT_GT(cited, 70u);
  for (const std::string& work : works)
    EXPECT_NE(all.find(work.substr(0, work.find_first_of(", ", work.starts_with("van ") ? 8 : 0))),
              std::string::npos)
        << "nobody names " << work;
}

TEST(References, ControlsOfTheirRule) {
  EXPECT_EQ(cited_in("by the method [of\n// Veach and Guibas\n// 1997, 5.3.4; Veach 1997, 11.4.4]"),
            (Citations{"Veach and Guibas 1997", "Veach 1997"}));
  EXPECT_EQ(cited_in("[dual-weighted residuals: Becker and Rannacher 2001, for radiosity "
                     "Lischinski et al. 1994]"),
            (Citations{"Becker and Rannacher 2001", "Lischinski et al. 1994"}));
  EXPECT_EQ(cited_in("[van der Walt and Smith 2015]"), Citations{"van der Walt and Smith 2015"});
  EXPECT_EQ(cited_in("[Sobol' 1967; Möller and Trumbore 1997]"),
            (Citations{"Sobol' 1967", "Möller and Trumbore 1997"}));
  EXPECT_EQ(cited_in("x[2000] and [Nobody](page.md) of 1997, [2016, 1997]"), Citations{});
}

}  // namespace
}  // namespace wander::test::references
