// What a run says that it needs is held against what the program takes; and a run that would not
// fit says so.
#include "lab/memory_need.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "scenes/format/scene_file.h"
#include "tests/support/expect.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

struct Case {
  const char* method;
  int bins;
  const char* options = "";
};

class MemoryOfRuns : public CommandLine {
 protected:
  void write_box(int bins) const {
    nlohmann::json scene = nlohmann::json::parse(box);
    scene["shapes"][2]["sensor"]["bins"] = bins;
    std::ofstream(folder / "film.json") << scene;
  }
  // Bytes at the most, of the program alone.
  double used_by(const Case& c) const {
    const pid_t child = fork();
    if (child == 0) {
      fs::current_path(folder);
      const std::string line = std::string("exec '") + WANDER_PROGRAM + "' render film.json -m " +
                               c.method + " -b 50k -q -t 2 -o run --force " + c.options;
      execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    EXPECT_EQ(status, 0) << c.method;
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
  }
  double said_of(const Case& c) const {
    const SceneDocument document = read_scene_file(folder / "film.json");
    Dials dials;
    if (std::string_view(c.options).find("--by-length") != std::string_view::npos)
      dials.film.by_length = Keep::always;
    if (std::string_view(c.options).find("--maps") != std::string_view::npos)
      dials.film.maps = Keep::always;
    return memory_need({document.scene, find_method(c.method), dials}, 2).most();
  }
};

TEST_F(MemoryOfRuns, IsBetweenHalfOfWhatTheySayAndTheWhole) {
  for (const Case& c : {Case{"bdpt", 100},
                        {"mlt", 100},
                        {"bdpt", 16'000},
                        {"mlt", 16'000},
                        {"pssmlt", 16'000},
                        {"mmlt", 16'000},
                        {"pt", 1'000'000},
                        {"bdpt", 1'000'000, "--by-length"},
                        {"mlt", 1'000'000},
                        {"mlt", 1'000'000, "--by-length --maps"},
                        {"pssmlt", 1'000'000},
                        {"mmlt", 1'000'000}}) {
    write_box(c.bins);
    const double used = used_by(c), said = said_of(c);
    std::cout << c.method << ' ' << c.bins << ' ' << c.options << ": used " << used / 1e6
              << " MB of " << said / 1e6 << '\n';
    EXPECT_LT(used, said) << c.method << ' ' << c.bins;
    EXPECT_GT(used, said / 2) << c.method << ' ' << c.bins;
  }
}

TEST_F(MemoryOfRuns, ThatWouldNotFitIsRefusedBeforeTheyBegin) {
  write_box(10'000'000);
  const Outcome outcome = shell(
      "ulimit -v 700000; \"$WANDER\" render film.json -m mlt -b 1M --by-length --json -o run");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_HAS(outcome.err, "GB of memory, and the limit of addresses (ulimit -v) has");
  EXPECT_HAS(outcome.err, "no --by-length");
  EXPECT_HAS(outcome.out, "\"error\"");
  EXPECT_FALSE(exists("run/run.json"));
}

TEST_F(MemoryOfRuns, IsSaidWhereItIsMuch) {
  EXPECT_LACKS(wander("render box.json -m mlt -b 10k -o a").err, "GB");
  EXPECT_HAS(wander("render box.json -m mlt -b 10k -o b -v").err, "the run needs about 0.");
}

// The netCDF library dies where there is no more; a limit within reach of what the program takes.
TEST_F(MemoryOfRuns, ThatTheTrajectoryFileHasNotIsSaid) {
  int refused = 0;
  for (int kilobytes = 120'000; kilobytes < 180'000; kilobytes += 1'500) {
    const Outcome outcome =
        shell("ulimit -v " + std::to_string(kilobytes) +
              "; \"$WANDER\" trace box.json --steps 30 -t 1 -q -o steps.nc --force");
    if (outcome.exit_code == 127) continue;  // the program itself could not be loaded
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << outcome.exit_code;
    if (outcome.exit_code == 0) continue;
    EXPECT_EQ(outcome.err, "error: out of memory\n");
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

TEST_F(MemoryOfRuns, LetsNoMoreThreadsStartThanThereIsRoomFor) {
  const Outcome few =
      shell("ulimit -v 900000; \"$WANDER\" render box.json -m bdpt -b 20k -t 500 -q --json -o few");
  ASSERT_EQ(few.exit_code, 0) << few.err;
  const nlohmann::json run = nlohmann::json::parse(few.out);
  EXPECT_LT(run["threads"], 500);
  EXPECT_HAS(run["warnings"].dump(), "of the 500 threads could be started");
  const Outcome one = wander("render box.json -m bdpt -b 20k -t 1 -q --json -o one");
  EXPECT_EQ(nlohmann::json::parse(one.out)["film"]["value"], run["film"]["value"]);
}

}  // namespace
}  // namespace wander::test
