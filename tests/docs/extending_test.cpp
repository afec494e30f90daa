// docs/extending.md shows the files that are compiled and tested, and its changes apply to the
// sources.  extending_test.py builds the program with them.
#include <regex>
#include <vector>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

const fs::path root = WANDER_SOURCE;

std::string page() { return contents(root / "docs/extending.md"); }

TEST(ExtendingPage, ShowsTheExamplesAsTheyAreTested) {
  for (const char* example : {"sensor_slide.h", "parabola.h", "toss.h"}) {
    const std::string text = contents(root / "docs/examples" / example);
    ASSERT_FALSE(text.empty()) << example;
    EXPECT_NE(page().find("```cpp\n" + text + "```\n"), std::string::npos) << example;
  }
}

// What it shows once more, piece by piece, is in them too.
TEST(ExtendingPage, ShowsPiecesOfTheExamples) {
  const std::string text = page();
  const std::regex block("```cpp\n([^`]*)```\n");
  std::string examples;
  for (const auto& entry : fs::directory_iterator(root / "docs/examples"))
    if (entry.is_regular_file()) examples += contents(entry.path());
  std::size_t count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), block), end; it != end; ++it, ++count)
    EXPECT_NE(examples.find((*it)[1].str()), std::string::npos) << (*it)[1];
  EXPECT_EQ(count, 5u);
}

class ExtendingChanges : public CommandLine {
 protected:
  // The changes of the page, in its order; the first lines of each name a file.
  static std::vector<std::string> changes() {
    const std::string text = page();
    const std::regex block("```diff\n([^`]*)```\n");
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), block), end; it != end; ++it)
      found.push_back((*it)[1]);
    return found;
  }
  static std::string file_of(const std::string& change) {
    std::smatch found;
    return std::regex_search(change, found, std::regex("\\+\\+\\+ b/(\\S+)\n")) ? found[1].str()
                                                                                : std::string();
  }
  // Into the folder of the test.
  void copy(const fs::path& from, const fs::path& to) const {
    fs::create_directories((folder / to).parent_path());
    fs::copy_file(from, folder / to);
  }
  Outcome apply(const std::string& change) const {
    write("change.diff", change);
    return shell("patch -p1 < change.diff");
  }
};

TEST_F(ExtendingChanges, ApplyToTheSources) {
  std::vector<std::string> files;
  for (const std::string& change : changes()) {
    const std::string file = file_of(change);
    const bool is_example = file == "mutations/sensor_slide.h";
    copy(is_example ? root / "docs/examples/sensor_slide.h" : root / file, file);
    const Outcome applied = apply(change);
    EXPECT_EQ(applied.exit_code, 0) << applied.out << applied.err;
    EXPECT_LACKS(applied.out, "fuzz");
    files.push_back(file);
  }
  EXPECT_EQ(files, (std::vector<std::string>{"mutations/catalogue.h", "mutations/sensor_slide.h",
                                             "core/geometry/shape.h", "schema/scene.schema.json",
                                             "lab/method.cpp"}));
}

// No other file of the program is touched, and each is one that the table of the page names.
TEST_F(ExtendingChanges, AreToTheFilesThatTheTableNames) {
  const std::string table = page().substr(0, page().find("\n## "));
  for (const std::string& change : changes()) {
    const std::string file = file_of(change);
    if (file == "mutations/sensor_slide.h" || file.starts_with("schema/")) continue;
    EXPECT_HAS(table, "`" + file + "`");
  }
}

TEST_F(ExtendingChanges, ThatDoNotApplyAreSeen) {
  copy(root / "mutations/lens.h", "mutations/catalogue.h");
  EXPECT_NE(apply(changes().front()).exit_code, 0);
}

// A scene with the shape of the page is read by the schema that the page makes.
TEST_F(ExtendingChanges, MakeASchemaThatKnowsTheShape) {
  copy(root / "schema/scene.schema.json", "schema/scene.schema.json");
  for (const std::string& change : changes()) {
    if (file_of(change) != "schema/scene.schema.json") continue;
    ASSERT_EQ(apply(change).exit_code, 0);
  }
  EXPECT_HAS(contents(folder / "schema/scene.schema.json"), "\"parabola\": {");
  EXPECT_HAS(contents(root / "docs/examples/dish.json"), "\"type\": \"parabola\"");
}

}  // namespace
}  // namespace wander::test
