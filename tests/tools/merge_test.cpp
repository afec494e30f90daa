// `wander merge`: runs in directories become one, and what is no part of one run is refused.
#include "tests/tools/killed_runs.h"

namespace wander::test {
namespace {

class Merge : public KilledRuns {
 protected:
  // Into a directory of that name.
  void render(const std::string& name, const std::string& arguments) {
    const Outcome outcome = wander("render box.json -q -o " + name + " " + arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  void render_pair(const std::string& arguments) {
    render("a", arguments + " -s 1");
    render("b", arguments + " -s 2");
  }
  void expect_refused(const std::string& arguments, int exit_code,
                      std::initializer_list<const char*> words) {
    const std::size_t before = entries();
    SCOPED_TRACE(arguments);
    expect_one_fault(wander("merge " + arguments), exit_code, words);
    EXPECT_EQ(entries(), before) << arguments;
  }
  json record_in(const std::string& directory) const {
    return json::parse(contents(folder / directory / "run.json"));
  }
};

TEST_F(Merge, InAnyOrderHasTheSameBits) {
  for (const std::string method : {"bdpt", "mlt", "mmlt --precision float"}) {
    SCOPED_TRACE(method);
    render("a", "--force -m " + method + " -b 20k -s 3");
    render("b", "--force -m " + method + " -b 70k -s 12");
    render("c", "--force -m " + method + " -b 20k -s 1");
    ASSERT_EQ(wander("merge a b c -o one -q --force -t 1").exit_code, 0);
    ASSERT_EQ(wander("merge c b a -o other -q --force -t 3").exit_code, 0);
    EXPECT_EQ(numbers_in("one"), numbers_in("other"));
    EXPECT_EQ(contents(folder / "one/film.csv"), contents(folder / "other/film.csv"));
    const json record = record_in("one");
    EXPECT_EQ(record["samples"], 110'000);
    EXPECT_EQ(record["seed"], 1);
    ASSERT_EQ(record["merged"].size(), 3u);
    EXPECT_EQ(record["merged"][2]["seed"], 12);
    EXPECT_EQ(record["merged"][2]["samples"], 70'000);
  }
}

TEST_F(Merge, OfOneRunHasItsNumbers) {
  render("a", "-m mlt -b 20k -s 5");
  ASSERT_EQ(wander("merge a -o same -q").exit_code, 0);
  json same = numbers_in("same");
  same.erase("merged");
  EXPECT_EQ(same, numbers_in("a"));
}

// The wrong twin: a run merged with itself would claim to know more than it does.
TEST_F(Merge, OfOneSeedTwiceIsRefused) {
  render_pair("-m bdpt -b 2k");
  expect_refused("a a -o both", 2, {"a and a have the same seed 1", "-s SEED"});
  render("c", "-m bdpt -b 3k -s 2");
  expect_refused("a b c -o all", 2, {"b and c have the same seed 2"});
}

TEST_F(Merge, OfWhatIsNotOneRunIsRefused) {
  write("other.json", std::string(box) + "\n");
  render_pair("-m pssmlt -b 2k --large-step 0.25");
  render("method", "-m mmlt -b 2k -s 4 --large-step 0.250");
  render("dials", "-m pssmlt -b 2k -s 5 --kernel 2");
  render("precision", "-m pssmlt -b 2k -s 6 --large-step 0.25 --precision float");
  ASSERT_EQ(
      wander("render other.json -m pssmlt --large-step 0.25 -b 2k -s 7 -q -o scene").exit_code, 0);
  expect_refused("a method -o x", 2,
                 {"run in method cannot be merged with that in a", "its method is mmlt, not pssmlt",
                  "seeds alone"});
  expect_refused(
      "a dials -o x", 2,
      {"its --large-step is the usual one, not 0.25", "its --kernel is 2, not the usual one"});
  expect_refused("b precision -o x", 2, {"its --precision is float, not the usual one"});
  expect_refused("b scene -o x", 2, {"its scene is other.json (sha256 ", "not box.json (sha256 "});
  render("same", "-m pssmlt -b 2k -s 8 --large-step 0.250");
  EXPECT_EQ(wander("merge a same -q -o x").exit_code, 0);
}

TEST_F(Merge, NeedsTheCheckpointOfEachRun) {
  render_pair("-m bdpt -b 2k");
  render("bare", "-m bdpt -b 2k -s 3 --checkpoint 0");
  expect_refused("a bare -o x", 2, {"bare holds no checkpoint", "--checkpoint 0", "leave it out"});
  expect_refused("a nowhere -o x", 2, {"nowhere: there is no such directory"});
  const Outcome both = wander("merge bare a nowhere -o x");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_HAS(both.err, "bare holds no checkpoint");
  EXPECT_HAS(both.err, "nowhere: there is no such directory");
}

TEST_F(Merge, OfADamagedRunIsRefused) {
  render_pair("-m mlt -b 2k");
  const std::string whole = contents(folder / "b/checkpoint");
  const auto put = [&](const std::string& bytes) { write("b/checkpoint", bytes); };
  put(whole.substr(0, whole.size() / 2));
  expect_refused("a b -o x", 3, {"b/checkpoint: ", "damaged", "leave it out"});
  put("mine");
  expect_refused("a b -o x", 3, {"is not a checkpoint"});
  std::string other(*unsealed(whole));
  other.replace(other.find("\"version\":\""), 11, "\"version\":\"9.");
  put(sealed(other));
  expect_refused("a b -o x", 3, {"of version 9."});
  put(whole);
  write("b/run.json", R"({"schema":"wanderlight-run/1"})");
  expect_refused("a b -o x", 3, {"b/run.json: /scene: it is missing; not a run"});
}

TEST_F(Merge, OfARunWithoutSamplesIsRefused) {
  render("a", "-m mlt -b 2k");
  const Outcome killed = shell(
      "timeout -s KILL 0.3 \"$WANDER\" render box.json -m mlt -b 100M --seed-share 100 -s 2 -q "
      "-o b --checkpoint 60");
  ASSERT_EQ(killed.exit_code, 137);
  expect_refused("a b -o x", 2, {"b holds a run without samples", "render --continue -o b"});
}

TEST_F(Merge, OfAnInterruptedRunIsIncomplete) {
  render("a", "-m bdpt -b 2k");
  ASSERT_EQ(shell("timeout -s INT 0.3 \"$WANDER\" render box.json -m bdpt -b 100G -s 2 -q -o b")
                .exit_code,
            124);
  const Outcome outcome = wander("merge a b -o both");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_HAS(outcome.err, "INCOMPLETE, a part of it was interrupted");
  EXPECT_HAS(outcome.err, "1 of 2 runs did not come to the end of their budgets: b");
  const json record = record_in("both");
  EXPECT_FALSE(record["complete"]);
  EXPECT_TRUE(record["merged"][0]["complete"]);
  EXPECT_FALSE(record["merged"][1]["complete"]);
  EXPECT_EQ(record["samples"].get<std::uint64_t>(),
            2'000 + record_in("b")["samples"].get<std::uint64_t>());
  // So is one that never came to its record.
  render("c", "-m bdpt -b 2k -s 3");
  fs::remove(folder / "c/run.json");
  ASSERT_EQ(wander("merge a c -q -o other").exit_code, 0);
  EXPECT_FALSE(record_in("other")["complete"]);
}

TEST_F(Merge, HasTheTimesOfAllRuns) {
  render_pair("-m mlt -b 20k -t 2");
  ASSERT_EQ(wander("merge a b -q -o both").exit_code, 0);
  const json both = record_in("both"), a = record_in("a"), b = record_in("b");
  EXPECT_EQ(both["threads"], 2);
  // The record of a run is made before its checkpoint.
  for (const char* time : {"seconds", "cpu_seconds", "seed_seconds"}) {
    const double sum = a[time].get<double>() + b[time].get<double>();
    EXPECT_GE(both[time].get<double>(), sum * (1 - 1e-12)) << time;
  }
  EXPECT_EQ(both["merged"][0]["seconds"].get<double>() + both["merged"][1]["seconds"].get<double>(),
            both["seconds"].get<double>());
}

// ---- outputs

TEST_F(Merge, MakesARunAsOthersAre) {
  render_pair("-m mlt -b 20k");
  const Outcome merged = wander("merge a b -o both --json");
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(json::parse(merged.out), record_in("both"));
  EXPECT_HAS(merged.err, "mlt: 40 k samples");
  EXPECT_HAS(merged.err, "2 runs of seeds 1 to 2");
  EXPECT_HAS(merged.err, "128 chains in 128 groups");
  EXPECT_HAS(merged.err, "saved in        both");
  for (const char* command :
       {"plot both/run.json -o film.svg", "plot both -o film.png", "inspect both",
        "inspect both/film.exr", "inspect a --reference both",
        "compare box.json -m bdpt -b 1k --replicates 2 --reference both/run.json -o duel -q"}) {
    const Outcome outcome = wander(command);
    EXPECT_EQ(outcome.exit_code, 0) << command << outcome.err;
  }
  const json shown = json::parse(wander("inspect both --json").out);
  EXPECT_EQ(shown["merged"].size(), 2u);
  EXPECT_HAS(contents(folder / "both/film.exr"), "merged_seeds");
}

TEST_F(Merge, NeedsAPlaceForItsOutput) {
  render_pair("-m bdpt -b 2k");
  expect_refused("a b", 2, {"merge needs -o DIR", "--json"});
  expect_refused("a b -o b --force", 2, {"-o b is one of those that are read"});
  render("old", "-m pt -b 2k");
  expect_refused("a b -o old", 2, {"old holds a run", "--force"});
  EXPECT_EQ(wander("merge a b -o old --force -q").exit_code, 0);
  EXPECT_FALSE(exists("old/checkpoint"));
  EXPECT_EQ(wander("merge a b --json -q").exit_code, 0);
  EXPECT_EQ(wander("merge").exit_code, 2);
}

TEST_F(Merge, MakesNoPartOfAnother) {
  render_pair("-m bdpt -b 2k");
  render("c", "-m bdpt -b 2k -s 3");
  ASSERT_EQ(wander("merge a b -q -o both").exit_code, 0);
  expect_refused("both c -o all", 2, {"both holds runs that were merged already", "name those"});
  const Outcome outcome = wander("render --continue -o both -b 10k");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_HAS(outcome.err, "both holds merged runs");
  EXPECT_HAS(outcome.err, "merge them again with --force");
}

}  // namespace
}  // namespace wander::test
