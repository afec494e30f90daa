// `render --continue`: a run that was killed, interrupted or finished goes on with the bits of one
// that never stopped, and what cannot go on says why.
#include <nlohmann/json.hpp>
#include <random>

#include <fmt/format.h>

#include "tests/tools/killed_runs.h"

namespace wander::test {
namespace {

class Continuing : public KilledRuns {
 protected:
  void expect_refused(const std::string& arguments, int exit_code,
                      std::initializer_list<const char*> words) {
    SCOPED_TRACE(arguments);
    expect_one_fault(wander(arguments), exit_code, words);
  }
};

TEST_F(Continuing, KilledAnywhereItHasTheSameBits) {
  expect_same_after_kills("bdpt", "1M", 3, 1);
  for (const char* method : {"mlt", "mmlt --precision float"})
    expect_same_after_kills(method, "60k", 3, 1);
}

TEST_F(Continuing, AnInterruptedRunGoesOnToItsEnd) {
  const std::string run = "render box.json -m mlt -b 150k -q -o ";
  ASSERT_EQ(wander(run + "whole").exit_code, 0);
  const std::string interrupted_once_it_samples =
      "\"$WANDER\" " + run +
      "cut -t 1 --progress json 2>progress & job=$!; until grep -q sampling progress || ! kill -0 "
      "$job; do sleep 0.01; done; kill -INT $job; wait $job";
  EXPECT_EQ(shell(interrupted_once_it_samples).exit_code, 130);
  EXPECT_FALSE(json::parse(contents(folder / "cut/run.json"))["complete"]);
  EXPECT_EQ(wander("render --continue -o cut -q").exit_code, 0);
  EXPECT_EQ(numbers_in("cut"), numbers_in("whole"));
}

// Also in the pilot, of which nothing is kept.
TEST_F(Continuing, AnInterruptedRunSaysSoHoweverEarly) {
  for (const char* seconds : {"0.05", "0.1", "0.2", "0.4"})
    EXPECT_EQ(shell(std::string("timeout --preserve-status -s INT ") + seconds +
                    " \"$WANDER\" render gallery:cornell -m mlt -b 100M -t 1 --force -o early")
                  .exit_code,
              130)
        << seconds;
}

TEST_F(Continuing, AFinishedRunGoesOnToALargerBudget) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 30001 -q -o long").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m bdpt -b 10003 -q -o short").exit_code, 0);
  const Outcome outcome = wander("render --continue -o short -b 30001");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_HAS(outcome.err, "carried on from 10003 samples, to 30001");
  EXPECT_EQ(numbers_in("short"), numbers_in("long"));
  ASSERT_EQ(wander("render box.json -m mlt -b 2k --film chains -q -o chains").exit_code, 0);
  const Outcome chains = wander("render --continue -o chains -b 5k");
  EXPECT_EQ(chains.exit_code, 0) << chains.err;
  EXPECT_HAS(chains.err, "the seed pass and the number of chains stay");
  EXPECT_EQ(numbers_in("chains")["samples"], 5000);
}

// Such a plan leaves the light to the seed pass, of which many steps have a small part.
TEST_F(Continuing, ThePlanOfFewStepsIsNotCarriedOnToMany) {
  const auto border = [&](const std::string& run) {
    return json::parse(contents(folder / run / "run.json"))["pooling"]["border"].get<double>();
  };
  ASSERT_EQ(wander("render gallery:slit -m mlt -b 5k -q -o whole").exit_code, 0);
  ASSERT_EQ(wander("render gallery:slit -m mlt -b 200 -q -o few").exit_code, 0);
  ASSERT_LT(border("few"), border("whole") / 2) << "plans that do not differ show nothing";
  const Outcome outcome = wander("render --continue -o few -b 5k");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_HAS(outcome.err, "begun again");
  EXPECT_EQ(numbers_in("few"), numbers_in("whole"));
  EXPECT_LACKS(wander("render --continue -o few -b 5k").err, "begun again");
}

// Nothing is lost to a budget that asks for no more than there is, nor does one that is met go beyond it.
TEST_F(Continuing, ThePlanOfFewStepsStaysWhereNothingIsLeftToDo) {
  for (const char* steps : {"2k", "50k"}) {
    ASSERT_EQ(wander(std::string("render box.json -m mlt -q --force -o few -b ") + steps).exit_code,
              0);
    const json before = numbers_in("few");
    for (const char* budget : {"1ms", "0.001cpu-s", "error<90%"}) {
      SCOPED_TRACE(std::string(steps) + " " + budget);
      const Outcome outcome = wander(std::string("render --continue -o few -b '") + budget + "'");
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_HAS(outcome.err, "nothing to do: ");
      EXPECT_EQ(numbers_in("few")["film"], before["film"]);
      const Outcome plain = wander("render --continue -o few");
      EXPECT_EQ(plain.exit_code, 0) << plain.err;
      EXPECT_EQ(numbers_in("few")["samples"], before["samples"]);
    }
  }
}

TEST_F(Continuing, ABudgetIsTheSameHoweverItIsWritten) {
  shell(
      "\"$WANDER\" render gallery:slit -m mlt -b 520k -t 1 -q -o cut --checkpoint 0.05 & run=$!; "
      "while [ ! -e cut/checkpoint ]; do sleep 0.01; done; kill -KILL $run");
  ASSERT_TRUE(exists("cut/checkpoint"));
  EXPECT_LACKS(wander("render --continue -o cut -b 520000").err, "begun again");
  ASSERT_EQ(wander("render gallery:slit -m mlt -b 520k -q -o whole").exit_code, 0);
  EXPECT_EQ(numbers_in("cut"), numbers_in("whole"));
}

// Nor to one that begins again and is stopped before it has come as far as the run was, whatever it is at: its pilot, its
// seeds, of which what it would show is more than 50 k steps, or its steps.
TEST_F(Continuing, WhatIsBegunAgainTakesTheOldRunsPlaceWhenThereIsAsMuch) {
  const auto file = [&](const char* name) { return contents(folder / "few" / name); };
  int stays = 0;
  for (const int steps : {50'000, 400'000}) {
    ASSERT_EQ(
        wander("render gallery:slit -m mlt -q -t 1 --force -o old -b " + std::to_string(steps))
            .exit_code,
        0);
    for (const char* stop : {"INT 0.1", "INT 0.2", "INT 0.3", "INT 0.4", "INT 0.6", "KILL 0.2",
                             "KILL 0.4", "KILL 0.8"}) {
      SCOPED_TRACE(fmt::format("{} of {}", stop, steps));
      shell("rm -rf few; cp -r old few");
      const std::string checkpoint = file("checkpoint"), film = file("film.exr");
      const Outcome outcome =
          shell(fmt::format("timeout --preserve-status -s {} \"$WANDER\" render --continue -o few "
                            "-b 40M -t 1 --checkpoint 0.02",
                            stop));
      EXPECT_TRUE(outcome.exit_code == 130 || outcome.exit_code == 137) << outcome.err;
      if (file("checkpoint") == checkpoint) {
        ++stays;
        EXPECT_TRUE(file("film.exr") == film) << "or the old one beside its checkpoint";
        continue;
      }
      EXPECT_TRUE(outcome.exit_code == 137 || file("film.exr") != film);
      ASSERT_EQ(wander("render --continue -o few -b 1ms -q -t 1").exit_code, 0);
      EXPECT_GE(numbers_in("few")["samples"].get<int>(), steps);
    }
  }
  EXPECT_GT(stays, 0);
}

// As where a disk was full when the last checkpoint was to be written.
TEST_F(Continuing, AFilmStaysThatIsAheadOfItsCheckpoint) {
  ASSERT_EQ(wander("render gallery:slit -m bdpt -q -t 1 -o run -b 10k").exit_code, 0);
  shell("cp run/checkpoint old");
  ASSERT_EQ(wander("render --continue -q -t 1 -o run -b 200k").exit_code, 0);
  shell("cp old run/checkpoint");
  const std::string film = contents(folder / "run/film.exr");
  expect_refused("render --continue -o run", 2, {"a film of 200000 samples", "-b 200000"});
  EXPECT_EQ(
      shell("timeout --preserve-status -s INT 0.3 \"$WANDER\" render --continue -o run -t 1 -b "
            "4000M --checkpoint 0.01")
          .exit_code,
      130);
  EXPECT_TRUE(contents(folder / "run/film.exr") == film ||
              numbers_in("run")["samples"].get<std::uint64_t>() >= 200'000);
  shell("cp old run/checkpoint");
  ASSERT_EQ(wander("render --continue -q -t 1 -o run -b 600k").exit_code, 0);
  EXPECT_EQ(numbers_in("run")["samples"], 600'000);
}

TEST_F(Continuing, ATimeIsThatOfTheWholeRun) {
  ASSERT_EQ(wander("render box.json -m pt -b 200ms -q -o run").exit_code, 0);
  const json before = numbers_in("run");
  ASSERT_EQ(wander("render --continue -o run -b 50ms -q").exit_code, 0);
  EXPECT_EQ(numbers_in("run")["samples"], before["samples"]) << "of that time nothing is left";
  ASSERT_EQ(wander("render --continue -o run -b 1s -q").exit_code, 0);
  EXPECT_GT(numbers_in("run")["samples"], before["samples"]);
}

TEST_F(Continuing, WhatIsGivenMustBeWhatTheRunHas) {
  ASSERT_EQ(wander("render box.json -m mlt --large-step 0.25 -b 2k -q -o run").exit_code, 0);
  const std::string before = contents(folder / "run/checkpoint");
  write("other.json", std::string(box) + "\n");
  expect_refused("render other.json --continue -o run", 2, {"its scene is box.json (sha256 "});
  expect_refused("render --continue -o run -m bdpt", 2, {"its method is mlt, not bdpt"});
  expect_refused("render --continue -o run -s 2", 2, {"its seed is 1, not 2"});
  expect_refused("render --continue -o run --large-step 0.5 --kernel 2", 2,
                 {"its --large-step is 0.25, not 0.5", "its --kernel is the usual one, not 2"});
  expect_refused("render --continue -o run -b 1k", 2, {"has 2000 samples already"});
  expect_refused("render --continue -o run --force", 2, {"leave one of them out"});
  expect_refused("render --continue", 2, {"--continue needs -o DIR"});
  EXPECT_EQ(contents(folder / "run/checkpoint"), before);
  EXPECT_EQ(wander("render box.json -m mlt --large-step 0.250 -s 1 --continue -o run -q").exit_code,
            0);
}

TEST_F(Continuing, WithoutACheckpointItSaysWhatToDo) {
  expect_refused("render --continue -o nowhere", 2, {"nowhere: there is no such directory"});
  ASSERT_EQ(wander("render box.json -m pt -b 2k --checkpoint 0 -q -o run").exit_code, 0);
  EXPECT_FALSE(exists("run/checkpoint"));
  expect_refused("render --continue -o run -b 4k", 2, {"run holds no checkpoint"});
}

TEST_F(Continuing, ADamagedCheckpointIsRefused) {
  ASSERT_EQ(wander("render box.json -m mlt -b 2k -q -o run").exit_code, 0);
  const std::string whole = contents(folder / "run/checkpoint");
  for (const std::size_t place : {std::size_t{40}, whole.size() / 2, whole.size() - 2}) {
    change("run/checkpoint", [&](std::string& bytes) { bytes[place] ^= 1; });
    expect_refused("render --continue -o run", 3, {"run/checkpoint: ", "damaged", "--force"});
    change("run/checkpoint", [&](std::string& bytes) { bytes = whole.substr(0, place); });
    expect_refused("render --continue -o run", 3, {"damaged or cut short"});
    change("run/checkpoint", [&](std::string& bytes) { bytes = whole; });
  }
  change("run/checkpoint", [](std::string& bytes) { bytes = "mine"; });
  expect_refused("render --continue -o run", 3, {"is not a checkpoint"});
  change("run/checkpoint", [](std::string& bytes) { bytes.clear(); });
  expect_refused("render --continue -o run", 3, {"is not a checkpoint"});
}

TEST_F(Continuing, ACheckpointOfAnotherVersionIsRefused) {
  ASSERT_EQ(wander("render box.json -m mlt -b 2k -q -o run").exit_code, 0);
  const std::string whole = contents(folder / "run/checkpoint");
  const std::string_view bytes = *unsealed(whole);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string other(bytes);
    other.replace(other.find(from), from.size(), to);
    change("run/checkpoint", [&](std::string& file) { file = sealed(other); });
  };
  with("wanderlight-checkpoint/13", "wanderlight-checkpoint/9");
  expect_refused("render --continue -o run", 3, {"its format is wanderlight-checkpoint/9"});
  with("\"version\":\"", "\"version\":\"9.");
  expect_refused("render --continue -o run", 3, {"of version 9."});
  with("\"method\"", "\"mathod\"");
  expect_refused("render --continue -o run", 3, {"its header cannot be read"});
  change("run/checkpoint", [&](std::string& file) {
    file = sealed(std::string(bytes.substr(0, bytes.size() - 10)));
  });
  expect_refused("render --continue -o run -q", 3, {"its state cannot be read"});
}

TEST_F(Continuing, ANewRunLeavesNothingOfTheOld) {
  ASSERT_EQ(wander("render box.json -m mlt -b 2k -q -o run").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m pt -b 1k -q -o run --force --checkpoint 0").exit_code, 0);
  EXPECT_FALSE(exists("run/checkpoint"));
}

TEST_F(Continuing, AnOutputThatExistsNamesBothWays) {
  ASSERT_EQ(wander("render box.json -m pt -b 1k -q -o run").exit_code, 0);
  expect_refused("render box.json -m pt -b 1k -o run", 2, {"--force", "--continue"});
  fs::remove(folder / "run/run.json");
  expect_refused("render box.json -m pt -b 1k -o run", 2, {"did not come to its end"});
}

}  // namespace
}  // namespace wander::test
