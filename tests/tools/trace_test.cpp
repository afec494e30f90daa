// `wander trace` as a user meets it: files, replayed steps, exit codes and messages.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "records/trajectory_netcdf.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;

class TraceCommand : public CommandLine {
 protected:
  std::vector<std::string> rows(const char* name) const {
    std::istringstream text(contents(folder / name));
    std::vector<std::string> rows;
    for (std::string row; std::getline(text, row);) rows.push_back(row);
    return rows;
  }
};

TEST_F(TraceCommand, LeavesAFileThatInspectAndTheSummaryAgreeOn) {
  const Outcome outcome = wander("trace box.json --steps 300 --chains 3 -o t.nc --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_HAS(outcome.err, "3 chains of 300 draws");
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["schema"], "wanderlight-trace/1");
  EXPECT_EQ(summary["complete"], true);
  EXPECT_EQ(summary["file"], "t.nc");
  EXPECT_GT(summary["normalization"]["value"], 0);
  std::uint64_t proposed = 0;
  for (const json& mutation : summary["mutations"])
    proposed += mutation["proposed"].get<std::uint64_t>();
  EXPECT_EQ(proposed, 900u);

  const Outcome inspected = wander("inspect t.nc --json");
  ASSERT_EQ(inspected.exit_code, 0) << inspected.err;
  const json held = json::parse(inspected.out);
  EXPECT_EQ(held["kind"], "trajectory");
  for (const char* key : {"chains", "draws", "mutations", "reasons", "classes", "normalization"})
    EXPECT_EQ(held[key], summary[key]) << key;
  EXPECT_HAS(wander("inspect t.nc").out, "bidirectional");
  EXPECT_EQ(wander("inspect t.nc --reference t.nc").exit_code, 2);

  const TrajectoryRecord record = read_trajectory(folder / "t.nc");
  EXPECT_EQ(record.provenance.scene_text, box);
  EXPECT_EQ(record.provenance.command_line,
            "wander trace box.json --steps 300 --chains 3 -o t.nc --json");
  EXPECT_EQ(record.seed, 1u);
}

TEST_F(TraceCommand, RecordsFourChainsOfAThousandStepsByDefault) {
  const Outcome outcome = wander("trace box.json --json -q");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["chains"], 4);
  EXPECT_EQ(summary["draws"], 1000);
  EXPECT_EQ(summary["method"], "mlt");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(TraceCommand, MakesTheSameFileForAnyNumberOfThreads) {
  for (const std::string threads : {"1", "3"})
    ASSERT_EQ(
        wander("trace box.json --steps 200 -q -o " + threads + ".csv -t " + threads).exit_code, 0);
  EXPECT_EQ(contents(folder / "1.csv"), contents(folder / "3.csv"));
  ASSERT_EQ(wander("trace box.json --steps 200 -q -o other.csv -s 2").exit_code, 0);
  EXPECT_NE(contents(folder / "1.csv"), contents(folder / "other.csv"));
}

TEST_F(TraceCommand, WritesRowsOfTheChosenSteps) {
  ASSERT_EQ(wander("trace box.json --chains 2 --steps 100 -o all.csv").exit_code, 0);
  ASSERT_EQ(wander("trace box.json --chains 2 --window 90:100 --every 3 -o some.csv").exit_code, 0);
  const std::vector<std::string> all = rows("all.csv"), some = rows("some.csv");
  ASSERT_EQ(all.size(), 201u);
  ASSERT_EQ(some.size(), 9u);
  EXPECT_EQ(some[0], all[0]);
  for (std::size_t chain = 0; chain < 2; ++chain)
    for (std::size_t draw = 0; draw < 4; ++draw)
      EXPECT_EQ(some[1 + 4 * chain + draw], all[1 + 100 * chain + 90 + 3 * draw]);
}

TEST_F(TraceCommand, UsesTheMutationsThatAreAskedFor) {
  const json summary =
      json::parse(wander("trace box.json --mutations primary=1 --steps 200 --json -q").out);
  EXPECT_FALSE(summary["mutations"].contains("bidirectional"));
  EXPECT_TRUE(summary["mutations"].contains("primary_small"));
}

TEST_F(TraceCommand, RecordsTheChainsOfMmltToo) {
  const Outcome outcome = wander("trace box.json -m mmlt --chains 8 --steps 50 -o t.nc --json -q");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["method"], "mmlt");
  for (const char* move : {"primary_small", "primary_large"})
    EXPECT_GT(summary["mutations"][move]["proposed"], 0) << move;
  EXPECT_EQ(read_trajectory(folder / "t.nc").method, "mmlt");
}

// ---- replay

TEST_F(TraceCommand, ReplaysTheStepThatWasRecorded) {
  ASSERT_EQ(wander("trace box.json --chains 2 --steps 40 -o t.nc -q").exit_code, 0);
  const Trajectory t = read_trajectory(folder / "t.nc").trajectory;
  std::size_t i = 50;  // of chain 1, where something was proposed
  while (t.proposed.vertices.at(i) == 0) ++i;
  const Outcome outcome = wander("trace box.json --replay 1:" + std::to_string(i - 40) + " --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json step = json::parse(outcome.out);
  EXPECT_EQ(step["mutation"], t.mutations.at(static_cast<std::size_t>(t.mutation[i])));
  EXPECT_EQ(step["accepted"], t.accepted[i] != 0);
  EXPECT_EQ(step["acceptance_rate"], t.acceptance[i]);
  EXPECT_EQ(step["x"]["f"]["log"], t.log_f_current[i]);
  EXPECT_EQ(step["y"]["f"]["log"], t.log_f_proposed[i]);
  EXPECT_EQ(step["forward"]["log"], t.log_forward[i]);
  EXPECT_EQ(step["reverse"]["log"], t.log_reverse[i]);
  EXPECT_EQ(step["uniform"].get<double>() < step["acceptance_rate"].get<double>(),
            t.accepted[i] != 0);
  for (const char* end : {"x", "y"}) {
    double f = 1;
    for (const json& vertex : step[end]["vertices"]) {
      f *= vertex["value"].get<double>();
      if (!vertex["geometry"].is_null()) f *= vertex["geometry"].get<double>();
    }
    EXPECT_NEAR(f, step[end]["f"]["value"].get<double>(), 1e-12 * f);
  }
  EXPECT_NEAR(
      step["selection"]["x"].get<double>() * step["mutation_forward"]["value"].get<double>(),
      step["forward"]["value"].get<double>(), 1e-12 * step["forward"]["value"].get<double>());
}

TEST_F(TraceCommand, ReplaysAsATableOfEveryFactor) {
  bool proposed = false, failed = false;
  for (int step = 0; step < 12; ++step) {
    const Outcome outcome = wander("trace box.json --replay 0:" + std::to_string(step));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_HAS(outcome.out, "path x: L");
    if (outcome.out.find("path y") == std::string::npos) {
      EXPECT_HAS(outcome.out, "no path was proposed");
      failed = true;
      continue;
    }
    proposed = true;
    for (const char* factor : {"f(x)", "f(y)", "s_m(x)", "s_m(y)", "T(x→y)", "T(y→x)", "a = min",
                               "uniform number", "G to next"})
      EXPECT_HAS(outcome.out, factor);
  }
  EXPECT_TRUE(proposed);
  EXPECT_TRUE(failed);
  EXPECT_EQ(entries(), 1u);
}

// ---- mistakes

TEST_F(TraceCommand, EveryMistakeInItsCommandLineIsExitTwo) {
  for (const char* arguments : {"trace",
                                "trace box.json",
                                "trace box.json -m bdpt --json",
                                "trace box.json -m nope --json",
                                "trace box.json -m pssmlt --json",
                                "trace box.json -m mmlt --json --mutations primary=1",
                                "trace box.json -m mmlt --replay 0:1",
                                "trace box.json -o t.nc --steps 0",
                                "trace box.json -o t.nc --steps many",
                                "trace box.json -o t.nc --chains 0",
                                "trace box.json -o t.nc --chains 257",
                                "trace box.json -o t.nc --every 0",
                                "trace box.json -o t.nc --window 5",
                                "trace box.json -o t.nc --window 5:5",
                                "trace box.json -o t.nc --window 0:11 --steps 10",
                                "trace box.json -o t.nc --steps 1000000000",
                                "trace box.json -o t.nc --mutations shove=1",
                                "trace box.json --replay 1",
                                "trace box.json --replay 1:x",
                                "trace box.json --replay -1:0",
                                "trace box.json --replay 1:2:3",
                                "trace box.json --replay 256:0",
                                "trace box.json --replay 4:1 --chains 4",
                                "trace box.json --replay 0:9 --steps 9",
                                "trace box.json --replay 0:1 -o t.nc"}) {
    const Outcome outcome = wander(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err, "") << arguments;
    EXPECT_EQ(entries(), 1u) << arguments;
  }
  EXPECT_HAS(wander("trace box.json -m bdpt --json").err, "one path");
  const Outcome unread = wander("trace box.json --replay 7");
  EXPECT_HAS(unread.err, "--replay");
  EXPECT_LACKS(unread.err, "trace needs -o");  // a replay writes no file
  EXPECT_HAS(wander("trace box.json -m mmlt --replay 0:1").err,
             "--replay takes apart steps of mlt");
}

TEST_F(TraceCommand, AnExistingFileIsReplacedOnlyWithForce) {
  write("t.nc", "mine");
  EXPECT_EQ(wander("trace box.json --steps 10 -o t.nc").exit_code, 2);
  EXPECT_EQ(contents(folder / "t.nc"), "mine");
  EXPECT_EQ(wander("trace box.json --steps 10 -o t.nc --force -q").exit_code, 0);
  EXPECT_EQ(wander("inspect t.nc").exit_code, 0);
}

TEST_F(TraceCommand, AFullDiskIsExitOneAndLeavesNothing) {
  for (const char* name : {"t.nc", "t.csv"}) {
    const std::string command =
        std::string("ulimit -f 1; \"$WANDER\" trace box.json -q -o ") + name;
    const Outcome outcome = shell("(" + command + " 2>&1; echo exit $?) | cat");
    EXPECT_HAS(outcome.out, std::string("cannot write ") + name + ": File too large");
    EXPECT_HAS(outcome.out, "exit 1");
  }
  EXPECT_EQ(entries(), 1u);
  const Outcome device = wander("trace box.json --steps 10 -o /dev/full -q");
  EXPECT_EQ(device.exit_code, 1);
  EXPECT_HAS(device.err, "cannot write /dev/full: No space left on device");
}

TEST_F(TraceCommand, AnUnwritablePlaceIsExitOneAndNamed) {
  const Outcome missing = wander("trace box.json -o missing/t.nc");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_HAS(missing.err, "cannot write missing/t.nc: No such file or directory");
  const Outcome below = wander("trace box.json -o box.json/t.nc");
  EXPECT_EQ(below.exit_code, 1);
  EXPECT_HAS(below.err, "cannot write box.json/t.nc: Not a directory");
}

TEST_F(TraceCommand, ABrokenOrForeignFileIsExitThree) {
  ASSERT_EQ(wander("trace box.json --steps 50 -o t.nc -q").exit_code, 0);
  write("half.nc", contents(folder / "t.nc").substr(0, 20'000));
  const Outcome half = wander("inspect half.nc --json");
  EXPECT_EQ(half.exit_code, 3);
  EXPECT_HAS(half.err, "half.nc: not a trajectory");
  EXPECT_HAS(json::parse(half.out)["error"]["message"].get<std::string>(), "half.nc");
  write("other.nc", "CDF\x01");
  EXPECT_EQ(wander("inspect other.nc").exit_code, 3);
}

TEST_F(TraceCommand, AnInvalidSceneIsExitThree) {
  write("bad.json", std::string(box).substr(0, 200));
  const Outcome outcome = wander("trace bad.json -o t.nc");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(outcome.err.starts_with("bad.json:")) << outcome.err;
  EXPECT_FALSE(exists("t.nc"));
}

TEST_F(TraceCommand, ASceneWithoutLightIsExitOneWithTheReason) {
  json scene = json::parse(box);
  std::swap(scene["shapes"][1]["from"], scene["shapes"][1]["to"]);  // it shines at the ceiling
  scene["max_vertices"] = 2;
  write("dark.json", scene.dump(1));
  const Outcome outcome = wander("trace dark.json -o t.nc");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_HAS(outcome.err, "found no light path");
  EXPECT_FALSE(exists("t.nc"));
}

TEST_F(TraceCommand, AnInterruptedTraceIsSavedAsIncomplete) {
  const Outcome outcome = shell(
      "\"$WANDER\" trace box.json --chains 2 --steps 4000000000 --every 1000 -o t.nc "
      "--progress json 2>log & run=$!; "
      "for i in $(seq 600); do grep -q sampling log && break; sleep 0.1; done; "
      "kill -INT $run; wait $run");
  ASSERT_EQ(outcome.exit_code, 130) << contents(folder / "log");
  EXPECT_HAS(contents(folder / "log"), "INCOMPLETE");
  const TrajectoryRecord record = read_trajectory(folder / "t.nc");
  EXPECT_FALSE(record.complete);
  EXPECT_GT(record.trajectory.draws, 0);
  EXPECT_EQ(json::parse(wander("inspect t.nc --json").out)["complete"], false);
}

}  // namespace
}  // namespace wander::test
