// A folder with a scene in it, and the built program to run there.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string>

namespace wander::test {

namespace fs = std::filesystem;

inline constexpr const char* box = R"({
  "format": "wanderlight-scene/1",
  "dimension": 2,
  "name": "box",
  "max_vertices": 4,
  "materials": { "wall": { "type": "diffuse", "reflectance": 0.5 } },
  "shapes": [
    { "type": "polyline", "points": [[0,0],[2,0],[2,1],[0,1]], "closed": true, "material": "wall" },
    { "type": "segment", "from": [1.5,0.9], "to": [0.5,0.9], "light": { "radiance": 5 } },
    { "type": "segment", "from": [0.5,0.1], "to": [1.5,0.1], "sensor": { "bins": 8 } }
  ]
})";

inline std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Outcome {
  int exit_code;
  std::string out, err;
};

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    std::string name = (fs::temp_directory_path() / "wander-command-XXXXXX").string();
    folder = mkdtemp(name.data());
    std::ofstream(folder / "box.json") << box;
  }
  ~CommandLine() override { fs::remove_all(folder); }

  // A line of shell, run in the folder of the test; $WANDER is the program.
  Outcome shell(const std::string& line) const {
    const std::string command = "cd '" + folder.string() + "' && export WANDER='" + WANDER_PROGRAM +
                                "' && { " + line + "; } 2>stderr";
    FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    char buffer[4096];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
    const int status = pclose(pipe);
    std::string err = contents(folder / "stderr");
    fs::remove(folder / "stderr");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out, err};
  }
  Outcome wander(const std::string& arguments) const { return shell("\"$WANDER\" " + arguments); }
  // Of the program, such as 0.1.0.
  std::string version() const {
    const std::string said = wander("--version").out;
    return said.substr(said.find(' ') + 1, said.find('\n') - said.find(' ') - 1);
  }

  void write(const char* name, const std::string& text) const {
    std::ofstream(folder / name) << text;
  }
  void change(const char* name, const std::function<void(std::string&)>& edit) const {
    std::string bytes = contents(folder / name);
    edit(bytes);
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }
  bool exists(const char* name) const { return fs::exists(folder / name); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
  }

  fs::path folder;
};

#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
#define EXPECT_LACKS(text, part) EXPECT_EQ((text).find(part), std::string::npos) << (text)

// One line that says why, with the exit code of the fault.
inline void expect_one_fault(const Outcome& outcome, int exit_code,
                             std::initializer_list<const char*> words) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  for (const char* word : words) EXPECT_HAS(outcome.err, word);
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}

}  // namespace wander::test
