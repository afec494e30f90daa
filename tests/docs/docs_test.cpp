// What README.md and docs/ say exists: the verbs and options of their console blocks, the files
// that they link to, and the sources that they name.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using Words = std::vector<std::string>;
using Faults = std::vector<std::string>;

std::vector<fs::path> documents() {
  std::vector<fs::path> files{fs::path(WANDER_SOURCE) / "README.md"};
  for (const auto& entry : fs::directory_iterator(fs::path(WANDER_SOURCE) / "docs"))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

// The words of each `$ wander …`, without the program, up to a comment, a pipe or a redirection.
std::vector<Words> commands_of(const std::string& text) {
  std::vector<Words> commands;
  std::istringstream lines(text);
  bool is_console = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) is_console = line == "```console";
    if (!is_console || !line.starts_with("$ wander ")) continue;
    Words& words = commands.emplace_back();
    std::istringstream rest(line.substr(std::string("$ wander ").size()));
    for (std::string word; rest >> word && word != "|" && word != ">" && word != "#";)
      words.push_back(word);
  }
  return commands;
}

class Program : public CommandLine {
 protected:
  // What `--help` explains; empty for a verb that there is not.
  const std::string& help(const std::string& verb) {
    const auto [found, is_new] = helps_.try_emplace(verb);
    if (is_new) {
      const std::string text = wander(verb + " --help").out;
      if (text.find("Usage: wander " + verb + " ") != std::string::npos) found->second = text;
    }
    return found->second;
  }

  Faults faults_of(const Words& command) {
    if (!command.empty() && command.front() == "--version") return {};
    if (command.empty() || help(command.front()).empty())
      return {"no verb: " + (command.empty() ? "" : command.front())};
    Faults faults;
    for (const std::string& word : command) {
      if (!word.starts_with("-")) continue;
      const std::string option = word.substr(0, word.find('='));
      const std::regex known("(^|[ ,])" + option + "[ ,\n]");
      if (!std::regex_search(help(command.front()), known))
        faults.push_back(command.front() + " has no " + option);
    }
    return faults;
  }

 private:
  std::map<std::string, std::string> helps_;
};

TEST_F(Program, KnowsTheVerbsAndOptionsOfTheDocuments) {
  std::size_t count = 0;
  for (const fs::path& file : documents())
    for (const Words& command : commands_of(contents(file))) {
      EXPECT_EQ(faults_of(command), Faults{}) << file;
      ++count;
    }
  EXPECT_GT(count, 10u);
}

TEST_F(Program, ControlsOfItsWords) {
  const auto faults = [&](const std::string& line) {
    const auto commands = commands_of("```console\n$ wander " + line + "\n```\n");
    return faults_of(commands.at(0)).size();
  };
  EXPECT_EQ(faults("render scene.json -m mlt --budget 5s | cat --nothing # --nothing"), 0u);
  EXPECT_EQ(faults("rendre scene.json"), 1u);
  EXPECT_EQ(faults("render scene.json --steps 5"), 1u);
  EXPECT_EQ(faults("trace scene.json --step 5"), 1u);
}

// ---- files

// Without fenced and indented blocks.
std::string prose_of(const std::string& text) {
  std::istringstream lines(text);
  std::string prose;
  bool is_fenced = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```"))
      is_fenced = !is_fenced;
    else if (!is_fenced && !line.starts_with("    "))
      prose += line + "\n";
  }
  return prose;
}

// Links, which are relative to the document, and sources in backquotes, which are to the root.
Faults missing_files(const std::string& text, const fs::path& folder) {
  static const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  static const std::regex source(
      R"(`((core|mlt|mutations|tools|tests|docs|scenes|schema)/[a-z0-9_/.-]+\.[a-z]+)`)");
  const std::string prose = prose_of(text);
  Faults faults;
  const auto require = [&](const fs::path& file) {
    if (!fs::exists(file)) faults.push_back(file.string());
  };
  for (std::sregex_iterator it(prose.begin(), prose.end(), link), end; it != end; ++it)
    require(folder / (*it)[1].str());
  for (std::sregex_iterator it(prose.begin(), prose.end(), source), end; it != end; ++it)
    require(fs::path(WANDER_SOURCE) / (*it)[1].str());
  return faults;
}

TEST(Documents, NameFilesThatExist) {
  for (const fs::path& file : documents())
    EXPECT_EQ(missing_files(contents(file), file.parent_path()), Faults{}) << file;
}

TEST(Documents, ControlsOfTheirFiles) {
  const fs::path docs = fs::path(WANDER_SOURCE) / "docs";
  EXPECT_EQ(missing_files("[a](../core/path.h) [b](mutations.md#lens) `core/path.h`", docs),
            Faults{});
  EXPECT_EQ(missing_files("[a](core/path.h)", docs).size(), 1u);
  EXPECT_EQ(missing_files("`tests/core/no_such_test.cpp`", docs).size(), 1u);
}

}  // namespace
}  // namespace wander::test
