// What a run says that it needs, held against what the program takes.
#pragma once

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "lab/memory_need.h"
#include "scenes/format/scene_file.h"
#include "tests/support/expect.h"
#include "tests/tools/command_line.h"

namespace wander::test {

struct CaseOfMemory {
  const char* method;
  int bins;
  const char* options = "";
  int max_vertices = 4;
  const char* budget = "50k";
};

class MemoryOfRuns : public CommandLine {
 protected:
  void write_box(const CaseOfMemory& c) const {
    nlohmann::json scene = nlohmann::json::parse(box);
    scene["max_vertices"] = c.max_vertices;
    scene["shapes"][2]["sensor"]["bins"] = c.bins;
    std::ofstream(folder / "film.json") << scene;
  }
  // Bytes at the most, of the program alone.
  double used_by(const CaseOfMemory& c) const {
    const pid_t child = fork();
    if (child == 0) {
      fs::current_path(folder);
      const std::string line = std::string("exec '") + WANDER_PROGRAM + "' render film.json -m " +
                               c.method + " -b " + c.budget + " -q -t 2 -o run --force " +
                               c.options;
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    EXPECT_EQ(status, 0) << c.method;
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
  }
  double said_of(const CaseOfMemory& c) const {
    const SceneDocument document = read_scene_file(folder / "film.json");
    Dials dials;
    if (std::string_view(c.options).find("--by-length") != std::string_view::npos)
      dials.film.by_length = Keep::always;
    if (std::string_view(c.options).find("--maps") != std::string_view::npos)
      dials.film.maps = Keep::always;
    return memory_need({document.scene, find_method(c.method), dials}, 2).most();
  }
  void expect_between_half_and_the_whole(std::initializer_list<CaseOfMemory> cases) const {
    for (const CaseOfMemory& c : cases) {
      write_box(c);
      const double used = used_by(c), said = said_of(c);
      std::cout << c.method << ' ' << c.bins << ' ' << c.options << ": used " << used / 1e6
                << " MB of " << said / 1e6 << '\n';
      EXPECT_LT(used, said) << c.method << ' ' << c.bins << ' ' << c.max_vertices;
      EXPECT_GT(used, said / 2) << c.method << ' ' << c.bins << ' ' << c.max_vertices;
    }
  }
};

}  // namespace wander::test
