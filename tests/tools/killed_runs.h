// Runs that are killed at random moments and carried on.
#pragma once

#include <nlohmann/json.hpp>
#include <random>

#include "records/seal.h"
#include "tests/tools/command_line.h"

namespace wander::test {

using nlohmann::json;

class KilledRuns : public CommandLine {
 protected:
  // Every number of run.json but times and facts of the execution.
  json numbers_in(const std::string& directory) const {
    json run = json::parse(contents(folder / directory / "run.json"));
    for (const char* fact :
         {"threads", "seconds", "cpu_seconds", "seed_seconds", "command_line", "provenance"})
      run.erase(fact);
    if (run.contains("chains")) run["chains"].erase("ess_per_second");
    if (run.contains("mutations"))
      for (json& mutation : run["mutations"]) mutation.erase("seconds");
    return run;
  }

  // SIGKILL after so many seconds, from the start of the program; then as a user would go on.
  void expect_same_after_kills(const std::string& method, const std::string& samples, int kills,
                               std::uint64_t seed) {
    SCOPED_TRACE(method);
    const std::string run = "render box.json -b " + samples + " -q -m " + method;
    ASSERT_EQ(wander(run + " -o whole --force").exit_code, 0);
    fs::remove_all(folder / "cut");
    std::mt19937_64 random(seed);
    int survived = 0;
    for (int kill = 0; kill < kills; ++kill) {
      const std::string command = exists("cut/checkpoint") ? "render --continue -q" : run;
      const double seconds = 0.02 + 0.15 * std::uniform_real_distribution()(random);
      const Outcome outcome =
          shell("timeout -s KILL " + std::to_string(seconds) + " \"$WANDER\" " + command +
                " -o cut --checkpoint 0.01 -t " + std::to_string(1 + kill % 3));
      ASSERT_TRUE(outcome.exit_code == 137 || outcome.exit_code == 0) << outcome.err;
      if (outcome.exit_code == 0) ++survived;
    }
    EXPECT_LT(survived, kills);
    if (!exists("cut/checkpoint")) fs::remove_all(folder / "cut");
    const std::string last = exists("cut/checkpoint") ? "render --continue -q" : run;
    const Outcome outcome = wander(last + " -o cut");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(numbers_in("cut"), numbers_in("whole"));
    EXPECT_EQ(contents(folder / "cut/film.csv"), contents(folder / "whole/film.csv"));
  }
};

}  // namespace wander::test
