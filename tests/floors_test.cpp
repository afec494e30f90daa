// The floors of the program, lowest first, are those below.  An include goes down or stays on its
// floor, a mutation includes no sibling, and no header includes itself by a detour.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace wander::test {
namespace {

namespace fs = std::filesystem;

// File name, from the root of the sources, to text.
using Sources = std::map<std::string, std::string>;
using Faults = std::vector<std::string>;

const std::vector<std::string> floors{"statistics", "work", "core", "mlt",   "mutations", "scenes",
                                      "records",    "lab",  "draw", "tools", "python"};

fs::path source_folder() {
#ifdef WANDER_SOURCE
  return WANDER_SOURCE;
#else
  return fs::path(__FILE__).parent_path().parent_path();
#endif
}

Sources read_sources() {
  Sources sources;
  for (const std::string& floor : floors)
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / floor)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      sources[fs::relative(entry.path(), source_folder()).generic_string()] = text.str();
    }
  return sources;
}

// What a file includes in quotes, which is the program's own.
std::vector<std::string> own_includes(const std::string& text) {
  static const std::regex line(R"re((?:^|\n)[ \t]*#[ \t]*include[ \t]*"([^"]+)")re");
  std::vector<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    names.push_back((*it)[1]);
  return names;
}

// -1: none of the program's floors.
int floor_of(const std::string& file) {
  const std::string folder = file.substr(0, file.find('/'));
  const auto it = std::find(floors.begin(), floors.end(), folder);
  return it == floors.end() ? -1 : static_cast<int>(it - floors.begin());
}

Faults upward_includes(const Sources& sources) {
  Faults faults;
  for (const auto& [file, text] : sources)
    for (const std::string& name : own_includes(text))
      if (floor_of(name) < 0 || floor_of(name) > floor_of(file))
        faults.push_back(file + " includes " + name);
  return faults;
}

// The mutations are what the catalogue includes.  One may know its own header and what no mutation
// is, such as a kernel in one coordinate or what several have in common.  The catalogue knows all.
Faults sibling_includes(const Sources& sources) {
  const std::string catalogue = "mutations/catalogue.h";
  std::set<std::string> mutations{catalogue};
  for (const std::string& name : own_includes(sources.at(catalogue)))
    if (name.starts_with("mutations/")) mutations.insert(name);
  Faults faults;
  for (const auto& [file, text] : sources) {
    if (!file.starts_with("mutations/") || file.starts_with("mutations/catalogue.")) continue;
    const std::string own_header = fs::path(file).replace_extension(".h").generic_string();
    for (const std::string& name : own_includes(text))
      if (mutations.contains(name) && name != own_header)
        faults.push_back(file + " includes its sibling " + name);
  }
  return faults;
}

// Exact answers share no code with the transport that is held against them.
Faults dependent_oracles(const Sources& sources) {
  Faults faults;
  for (const auto& [file, text] : sources) {
    if (!file.starts_with("core/exact/")) continue;
    for (const std::string& name : own_includes(text))
      if (!name.starts_with("core/exact/") && name != "core/description.h")
        faults.push_back(file + " includes " + name);
  }
  return faults;
}

class CircleSearch {
 public:
  explicit CircleSearch(const Sources& sources) : sources_(sources) {
    for (const auto& [file, text] : sources) visit(file);
  }
  const Faults& faults() const { return faults_; }

 private:
  void visit(const std::string& file) {
    const auto found = sources_.find(file);
    if (found == sources_.end() || done_.contains(file)) return;
    if (!open_.insert(file).second) {
      faults_.push_back(file + " includes itself by a detour");
      return;
    }
    for (const std::string& name : own_includes(found->second)) visit(name);
    open_.erase(file);
    done_.insert(file);
  }

  const Sources& sources_;
  std::set<std::string> open_, done_;
  Faults faults_;
};

Faults circles(const Sources& sources) { return CircleSearch(sources).faults(); }

TEST(Floors, AreAllRead) {
  const Sources sources = read_sources();
  for (const std::string& floor : floors)
    EXPECT_TRUE(std::ranges::any_of(sources, [&](const auto& s) {
      return s.first.starts_with(floor + "/");
    })) << floor;
  EXPECT_GT(own_includes(sources.at("core/scene.h")).size(), 2u);
}

TEST(Floors, IncludeOnlyDownwards) { EXPECT_EQ(upward_includes(read_sources()), Faults{}); }

TEST(Floors, KeepMutationsApart) { EXPECT_EQ(sibling_includes(read_sources()), Faults{}); }

TEST(Floors, KeepExactAnswersIndependent) {
  EXPECT_EQ(dependent_oracles(read_sources()), Faults{});
}

TEST(Floors, HaveNoCircles) { EXPECT_EQ(circles(read_sources()), Faults{}); }

// No room holds more than this share of the program, and no file more than so many lines.
constexpr double largest_share = 0.25;
constexpr long most_lines = 350;

long lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

Faults crowded(const Sources& sources) {
  Faults faults;
  std::map<int, double> lines;
  double all = 0;
  for (const auto& [file, text] : sources) {
    const auto count = static_cast<double>(lines_of(text));
    lines[floor_of(file)] += count;
    all += count;
    if (lines_of(text) > most_lines) faults.push_back(file + " is too long");
  }
  for (const auto& [floor, count] : lines)
    if (count > largest_share * all)
      faults.push_back(floors[static_cast<std::size_t>(floor)] + " holds too much");
  return faults;
}

TEST(Floors, HaveNoRoomThatIsCrowded) { EXPECT_EQ(crowded(read_sources()), Faults{}); }

// ---- controls: the checks themselves, on sources that are wrong

TEST(FloorChecks, CatchAnIncludeThatGoesUp) {
  EXPECT_EQ(upward_includes({{"core/a.h", "#include <vector>\n  #  include \"mlt/chain.h\"\n"}}),
            Faults{"core/a.h includes mlt/chain.h"});
  EXPECT_EQ(upward_includes({{"core/exact/a.cpp", "#include \"tools/b.h\""}}).size(), 1u);
  EXPECT_EQ(upward_includes({{"mlt/a.h", "#include \"mutations/lens.h\"\n"}}).size(), 1u);
  EXPECT_EQ(upward_includes({{"core/a.h", "#include \"tests/support/b.h\"\n"}}).size(), 1u);
  EXPECT_EQ(upward_includes({{"lab/a.h", "#include \"draw/figure/svg.h\"\n"}}).size(), 1u);
  EXPECT_TRUE(upward_includes(
                  {{"tools/a.cpp", "#include \"mutations/catalogue.h\"\n#include \"core/b.h\"\n"},
                   {"core/a.h", "// #include \"mlt/chain.h\"\n"}})
                  .empty());
}

TEST(FloorChecks, CatchAMutationThatKnowsItsSibling) {
  const auto faults = [](const std::string& file, const std::string& included) {
    return sibling_includes({{"mutations/catalogue.h",
                              "#include \"mutations/lens.h\"\n#include \"mutations/caustic.h\"\n"},
                             {file, "#include \"" + included + "\"\n"}})
        .size();
  };
  EXPECT_EQ(faults("mutations/lens.h", "mutations/caustic.h"), 1u);
  EXPECT_EQ(faults("mutations/lens.cpp", "mutations/catalogue.h"), 1u);
  EXPECT_EQ(faults("mutations/perturbation.h", "mutations/lens.h"), 1u);
  EXPECT_EQ(faults("mutations/lens.cpp", "mutations/lens.h"), 0u);
  EXPECT_EQ(faults("mutations/lens.h", "mutations/perturbation.h"), 0u);
}

TEST(FloorChecks, CatchAnExactAnswerThatLeansOnTheTransport) {
  EXPECT_EQ(dependent_oracles({{"core/exact/a.cpp", "#include \"core/scene.h\"\n"}}).size(), 1u);
  EXPECT_EQ(dependent_oracles({{"core/exact/a.cpp",
                                "#include \"core/exact/b.h\"\n#include \"core/description.h\"\n"},
                               {"core/a.cpp", "#include \"core/scene.h\"\n"}}),
            Faults{});
}

TEST(FloorChecks, CatchARoomThatIsCrowded) {
  const std::string line = "int x;\n";
  std::string many;
  for (long i = 0; i <= most_lines; ++i) many += line;
  EXPECT_EQ(crowded({{"core/a.h", many}}).size(), 2u);
  EXPECT_EQ(crowded({{"core/a.h", line + line},
                     {"mlt/a.h", line},
                     {"lab/a.h", line},
                     {"draw/a.h", line},
                     {"tools/a.h", line}}),
            Faults{"core holds too much"});
}

TEST(FloorChecks, CatchACircle) {
  const std::string a = "#include \"core/b.h\"\n", b = "#include \"core/c.h\"\n",
                    c = "#include \"core/a.h\"\n";
  EXPECT_EQ(circles({{"core/a.h", a}, {"core/b.h", b}, {"core/c.h", c}}).size(), 1u);
  EXPECT_EQ(circles({{"core/a.h", "#include \"core/a.h\""}}).size(), 1u);
  EXPECT_TRUE(circles({{"core/a.h", a}, {"core/b.h", b}, {"core/c.h", ""}}).empty());
  // Two ways to the same header are no circle.
  EXPECT_TRUE(circles({{"core/a.h", a + b}, {"core/b.h", b}, {"core/c.h", ""}}).empty());
}

}  // namespace
}  // namespace wander::test
