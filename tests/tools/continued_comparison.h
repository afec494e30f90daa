// Comparisons that are carried on with `compare --continue`.
#pragma once

#include "tests/lab/compare/compare_command.h"

namespace wander::test {

class ContinuingComparison : public CompareCommand {
 protected:
  // Every number of compare.json but times, and what is made of them, and facts of the execution.
  json numbers_in(const std::string& directory) const {
    json document = json::parse(contents(folder / directory / "compare.json"));
    json numbers{{"complete", document["complete"]},
                 {"reference", document["reference"]},
                 {"replicates", document["replicates"]},
                 {"failures", document["failures"]},
                 {"warnings", document["warnings"]}};
    for (json run : document["runs"]) {
      for (const char* time : {"seconds", "cpu_seconds", "seed_seconds", "command"})
        run.erase(time);
      numbers["runs"].push_back(run);
    }
    for (const json& cell : document["cells"])
      for (const char* error : {"relative_rmse", "rmse", "mae", "bias", "coverage"})
        numbers["cells"].push_back(cell[error]);
    for (json details : document["details"]) {
      for (const char* fact : {"threads", "seconds", "cpu_seconds", "seed_seconds", "command_line"})
        details.erase(fact);
      if (details.contains("chains")) details["chains"].erase("ess_per_second");
      if (details.contains("mutations"))
        for (json& mutation : details["mutations"]) mutation.erase("seconds");
      numbers["details"].push_back(details);
    }
    return numbers;
  }
  std::size_t kept_runs() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        fs::directory_iterator(folder / "cut/kept"),
        [](const auto& entry) { return entry.path().filename().string().starts_with("runs-"); }));
  }
  void expect_refused(const std::string& arguments, int exit_code,
                      std::initializer_list<const char*> words) {
    SCOPED_TRACE(arguments);
    expect_one_fault(compare(arguments), exit_code, words);
  }

  // Interrupted amid its runs of so many samples, then carried on.
  void expect_to_go_on(const std::string& scene, const std::string& budget) {
    const std::string all = scene + " -m pt,mlt -b " + budget + " --replicates 3 -o ";
    const Outcome first = interrupted_at("replicate [23] ", all + "cut");
    ASSERT_EQ(first.exit_code, 130) << first.err;
    const json before = numbers_in("cut");
    EXPECT_FALSE(before["complete"]);
    const std::size_t made = before["runs"].size();
    ASSERT_GT(made, 0u);
    ASSERT_LT(made, 6u);
    const Outcome second = compare("--continue -o cut");
    ASSERT_EQ(second.exit_code, 0) << second.err;
    EXPECT_HAS(second.err, "carried on from " + std::to_string(made) + " of 6 runs");
    EXPECT_HAS(second.err, std::to_string(6 - made) + " runs of " + budget + ": about ");
    const json after = numbers_in("cut");
    EXPECT_TRUE(after["complete"]);
    EXPECT_EQ(after["runs"].size(), 6u);
    EXPECT_EQ(after["reference"], before["reference"]) << "the reference is kept";
    for (std::size_t i = 0; i < made; ++i) EXPECT_EQ(after["runs"][i], before["runs"][i]);
    // The runs are those of a comparison that never stopped, against the same reference.
    ASSERT_EQ(compare(all + "whole -q --reference cut/reference.json").exit_code, 0);
    EXPECT_EQ(numbers_in("whole")["runs"], after["runs"]);
    // One that is finished has nothing more to make.
    const auto parts = kept_runs();
    const Outcome third = compare("--continue -o cut");
    EXPECT_EQ(third.exit_code, 0) << third.err;
    EXPECT_HAS(third.err, "carried on from 6 of 6 runs");
    EXPECT_LACKS(third.err, "runs of " + budget);
    EXPECT_EQ(kept_runs(), parts);
    EXPECT_EQ(numbers_in("cut"), after);
  }
};

}  // namespace wander::test
