// README.md and docs/, followed word by word: every command is run in an empty folder, in the order
// of its document, and what a document shows as printed is printed.
//
// Computations are shortened by one rule, and large scenes give way to small ones: `render` and `plot` compute 2k samples, also as jobs of
// GNU parallel, `compare` 1k and 2k twice, `check` 500.  What writes nothing is run where it is first met.  What cannot be run is in `not_run`, with the
// reason; the files, options, presets and targets that it names exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/tools/command_line.h"

namespace wander::test::readme_test {
namespace {

using Words = std::vector<std::string>;
using Faults = std::vector<std::string>;

const fs::path source = WANDER_SOURCE;

// First word of a command -> why it is not run.
const std::map<std::string, std::string> not_run{
    {"tools/quickstart", "installs packages, and takes minutes"},
    {"tools/install_dependencies", "installs packages"},
    {"tools/test", "runs this test"},
    {"tools/figure4", "takes hours"},
    {"tools/accuracy", "takes half an hour"},
    {"tools/normalization", "takes half an hour"},
    {"build/release/bin/wander_bench", "is not part of every build"},
    {"build/release/bin/wander_yardstick", "is not part of every build"},
    {"cmake", "takes minutes"},
    {"export", "is for the shell of the reader"},
    {"mkdir", "goes with the next"},
    {"for", "computes four exact films"},
    {"echo", "is for the shell of the reader"},
};
// Of a mutation, a shape or a method that the reader writes; the test Extending follows that
// document.  Of a scene that the reader has.
bool is_of_the_reader(const std::string& line) {
  const auto named = {"sensor_slide", "dish.json", "toss", "cbox.xml"};
  return std::ranges::any_of(
      named, [&](const char* name) { return line.find(name) != std::string::npos; });
}

struct Command {
  std::string line;
  Words printed{};
};

bool starts_command(const std::string& line) {
  static const std::regex known("(wander|parallel|tools/[a-z0-9_]+|build/[a-z/_]+|cmake) .*");
  return std::regex_match(line + " ", known);
}

std::string without_comment(std::string line) {
  line = line.substr(0, line.find("  #"));
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

// Of prose: in backquotes, with what the verb is to do; `wander check` alone names the verb.
void add_inline(const std::string& line, std::vector<Command>& commands) {
  static const std::regex quoted("`(wander (?:-|[A-Za-z]+ )[^`]*)`");
  for (std::sregex_iterator it(line.begin(), line.end(), quoted), end; it != end; ++it)
    commands.push_back({(*it)[1]});
}

// In console blocks, in indented blocks and in backquotes.
std::vector<Command> commands_of(const std::string& text) {
  std::vector<Command> commands;
  std::istringstream lines(text);
  std::string fence, prose;
  const auto end_paragraph = [&] {
    add_inline(prose, commands);
    prose.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      end_paragraph();
      fence = fence.empty() ? line : "";
    } else if (fence == "```console") {
      if (line.starts_with("$ "))
        commands.push_back({without_comment(line.substr(2))});
      else if (!commands.empty())
        commands.back().printed.push_back(line);
    } else if (fence.empty() && line.starts_with("    ")) {
      if (starts_command(line.substr(4))) commands.push_back({without_comment(line.substr(4))});
    } else if (fence.empty()) {
      if (line.empty()) end_paragraph();
      prose += (prose.empty() ? "" : " ") + line;
    }
  }
  end_paragraph();
  return commands;
}

std::string first_word(const std::string& line) { return line.substr(0, line.find(' ')); }

// What stands for a word in capitals; outputs have a name of their own each time.
class Placeholders {
 public:
  std::string filled(std::string line) {
    static const std::vector<std::pair<std::regex, std::string>> words{
        {std::regex(R"(\bSCENE\b)"), "gallery:slit"}, {std::regex(R"(\bMETHOD\b)"), "bdpt"},
        {std::regex(R"(\bM1,M2\b)"), "bdpt,mlt"},     {std::regex(R"(\bRUN\b(…)?)"), "a-run"},
        {std::regex(R"(\bVERB\b)"), "render"},        {std::regex(R"(\bNAME\b)"), "slit"}};
    for (const auto& [word, meaning] : words) line = std::regex_replace(line, word, meaning);
    const std::string number = std::to_string(++count_);
    line = std::regex_replace(line, std::regex(R"(-o DIR\b)"), "-o dir" + number);
    return std::regex_replace(line, std::regex(R"(-o FILE\.svg)"), "-o figure" + number + ".svg");
  }

 private:
  int count_ = 0;
};

// The line with small budgets; as it is where it computes nothing that could be long.
std::string shortened(const std::string& line) {
  static const std::regex budget(R"( (-b|--budget|--budgets|--samples|--replicates) [^ ]+)");
  const std::string bare = std::regex_replace(line, budget, "");
  if (line.starts_with("parallel "))
    return std::regex_replace(bare, std::regex(" wander render gallery:[^ ]+"),
                              " wander render gallery:slit -b 2k");
  if (line.starts_with("wander compare ")) {
    // Of a room that takes half of the time.
    static const std::regex in_space("gallery:cornell-glass");
    return std::regex_replace(bare, in_space, "gallery:slit-3d") + " -b 1k,2k --replicates 2";
  }
  if (line.starts_with("wander check ")) {
    static const std::regex extremes("gallery:[a-z0-9-]+(.* --extremes)");
    return std::regex_replace(bare, extremes, "gallery:parallel$1") + " --samples 500";
  }
  if (line.starts_with("wander render ") && line.find("--help") == std::string::npos)
    return bare + " -b 2k";
  const bool computes = bare != line || line.find(" --fluence") != std::string::npos;
  return computes ? bare + " -b 2k" : line;
}

bool is_run(const std::string& line) {
  return line.starts_with("wander ") || line.starts_with("parallel wander ");
}

bool is_program(const std::string& name) {
  for (const char* folder : {".", "tests", "tests/benchmarks"})
    if (contents(source / folder / "CMakeLists.txt").find("add_executable(" + name + " ") !=
        std::string::npos)
      return true;
  return false;
}

// Of a command that is not run.
Faults faults_of(const std::string& line, const std::string& document) {
  Faults faults;
  const std::string program = first_word(line);
  if (!not_run.contains(program)) return {"neither run nor excused: " + line};
  const auto require = [&](bool good, const std::string& what) {
    if (!good) faults.push_back(what + ": " + line);
  };
  if (program.starts_with("build/")) {
    const std::string name = fs::path(program).filename();
    require(is_program(name) && document.find("--target " + name) != std::string::npos,
            "nothing builds it");
  } else if (program.find('/') != std::string::npos) {
    require(fs::exists(source / program), "no such file");
    // What is quoted is for another program.
    const std::string own = std::regex_replace(line, std::regex("'[^']*'"), "");
    static const std::regex option(" (--[a-z0-9-]+)");
    for (std::sregex_iterator it(own.begin(), own.end(), option), end; it != end; ++it)
      require(contents(source / program).find((*it)[1]) != std::string::npos,
              "no " + (*it)[1].str());
  } else if (program == "cmake") {
    static const std::regex preset("--preset ([a-z]+)"), target("--target ([a-z_]+)");
    const std::string presets = contents(source / "CMakePresets.json");
    for (std::sregex_iterator it(line.begin(), line.end(), preset), end; it != end; ++it)
      require(presets.find("\"name\": \"" + (*it)[1].str() + "\"") != std::string::npos, "preset");
    for (std::sregex_iterator it(line.begin(), line.end(), target), end; it != end; ++it)
      require(is_program((*it)[1]), "target");
  }
  return faults;
}

// Folders that no clone has are made by a command that stands before.
Faults missing_results(const std::vector<Command>& commands) {
  static const std::regex result("results/[a-z0-9/-]*(?=/)");
  Faults faults;
  std::string before;
  for (const Command& command : commands) {
    const bool makes_it = command.line.starts_with("mkdir ");
    for (std::sregex_iterator it(command.line.begin(), command.line.end(), result), end;
         !makes_it && it != end; ++it)
      if (before.find(it->str()) == std::string::npos) faults.push_back(command.line);
    if (makes_it) before += command.line;
  }
  return faults;
}

// A finished run is not replaced without --force; {} stands for other names each time.
Faults reused_outputs(const std::vector<Command>& commands) {
  static const std::regex output(" -o ([a-z][^ {]*)(?= |$)(?!.* --force)");
  Faults faults;
  std::set<std::string> outputs;
  for (const Command& command : commands)
    if (std::smatch found; std::regex_search(command.line, found, output))
      if (!outputs.insert(found[1]).second) faults.push_back(command.line);
  return faults;
}

class Followed : public CommandLine {
 protected:
  void follow(const fs::path& file) {
    const std::string text = contents(file);
    const std::vector<Command> commands = commands_of(text);
    // The pages on figure4 show commands above the one that prepares them.
    std::vector<Command> preparing = commands;
    std::ranges::stable_partition(
        preparing, [](const Command& command) { return command.line.starts_with("mkdir "); });
    EXPECT_EQ(missing_results(preparing), Faults{}) << file;
    EXPECT_EQ(reused_outputs(commands), Faults{}) << file;
    if (text.find("RUN") != std::string::npos)
      wander("render gallery:slit -m mlt -b 2k -q -o a-run");
    Placeholders placeholders;
    for (const Command& command : commands) {
      if (is_of_the_reader(command.line)) continue;
      if (is_run(command.line)) {
        run(placeholders.filled(command.line), command.printed);
      } else {
        EXPECT_EQ(faults_of(command.line, text), Faults{}) << file;
      }
    }
  }

 private:
  void run(const std::string& line, const Words& printed) {
    const std::string command = shortened(line);
    static std::set<std::string> done;
    const bool writes = command.find(" -o ") != std::string::npos;
    if (!writes && printed.empty() && !done.insert(command).second) return;
    const Outcome outcome = shell(
        "export XDG_CACHE_HOME=\"$PWD/cache\" PATH=\"$(dirname \"$WANDER\"):$PATH\"; " + command);
    // Two thousand samples may find no light where the command itself finds some.
    const bool is_dark = command != line && outcome.exit_code == 1 &&
                         outcome.err.find("found no light path") != std::string::npos;
    // Five hundred may be too few for any test.
    const bool is_untested = command != line && outcome.exit_code == 4 &&
                             outcome.out.find("NOTHING COULD BE TESTED") != std::string::npos;
    const bool shows_faults = std::ranges::any_of(
        printed, [](const std::string& text) { return text.find("faulty.json:") == 0; });
    EXPECT_EQ(outcome.exit_code, is_dark        ? 1
                                 : shows_faults ? 3
                                 : is_untested  ? 4
                                                : 0)
        << command << outcome.err;
    if (command != line) return;
    const std::string all = "\n" + outcome.out + outcome.err;
    for (const std::string& text : printed)
      EXPECT_NE(all.find("\n" + text + "\n"), std::string::npos) << text << "\nof " << all;
  }
};

TEST_F(Followed, Readme) { follow(source / "README.md"); }
TEST_F(Followed, Mutations) { follow(source / "docs" / "mutations.md"); }
TEST_F(Followed, Trajectories) { follow(source / "docs" / "trajectories.md"); }
TEST_F(Followed, Gallery) { follow(source / "docs" / "gallery.md"); }

TEST_F(Followed, TheOtherDocuments) {
  const std::set<std::string> apart{"mutations.md", "trajectories.md", "gallery.md", "mutants.md"};
  for (const auto& entry : fs::directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md" && !apart.contains(entry.path().filename()))
      follow(entry.path());
}

TEST(Commands, ControlsOfTheirRules) {
  EXPECT_EQ(faults_of("tools/figure4 --ratio 8", "").size(), 0u);
  EXPECT_EQ(faults_of("tools/figure4 --ration 8", "").size(), 1u);
  EXPECT_EQ(faults_of("tools/figure5 --ratio 8", "").size(), 1u);
  EXPECT_EQ(faults_of("cmake --preset released", "").size(), 1u);
  EXPECT_EQ(faults_of("build/release/bin/wander_bench", "").size(), 1u);
  EXPECT_EQ(missing_results({{"tools/figure4 --reference a=results/exact/a.json"}}).size(), 1u);
  EXPECT_EQ(reused_outputs({{"wander render a -o b"}, {"wander render c -o b"}}).size(), 1u);
  EXPECT_EQ(reused_outputs({{"wander merge a -o b"}, {"wander merge c -o b --force"}}).size(), 0u);
  EXPECT_EQ(shortened("parallel wander render gallery:a -b 5M -s {} ::: 1"),
            "parallel wander render gallery:slit -b 2k -s {} ::: 1");
  EXPECT_EQ(shortened("wander render a -m mlt -b 5s -o b"), "wander render a -m mlt -o b -b 2k");
}

}  // namespace
}  // namespace wander::test::readme_test
