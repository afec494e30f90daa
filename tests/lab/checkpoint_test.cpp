// What is kept of a run is what is read again: how far it has come, and what it has seen on its way to an error.
#include "lab/checkpoint.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <ostream>

namespace wander::test::checkpoint_test {
namespace {

namespace fs = std::filesystem;

TEST(Checkpoints, HoldHowFarARunHasCome) {
  Checkpoint kept;
  kept.method = "mlt";
  kept.budget = "error<0.5%";
  kept.dials = {{"seed_share", "1"}};
  kept.seed = 7;
  kept.run.headway = {.wall_seconds = 1.5,
                      .processor_seconds = 2.5,
                      .seed_seconds = 0.5,
                      .samples = 3 << 20,
                      .target = 0.005,
                      .seed_goal = 1 << 10,
                      .goal = 4 << 20,
                      .looks = {{1 << 17, 0.1, 12.25}, {3 << 19, 0.0625, 1. / 3}}};
  const fs::path folder =
      fs::temp_directory_path() / ("wander-checkpoint-" + std::to_string(getpid()));
  fs::create_directory(folder);
  write_checkpoint(
      kept, [](std::ostream& bytes) { bytes << "the state"; }, folder);
  const Checkpoint read = read_checkpoint(folder, "");
  fs::remove_all(folder);
  EXPECT_EQ(read.run.headway, kept.run.headway);
  EXPECT_EQ(read.run.state, "the state");
  EXPECT_EQ(read.dials, kept.dials);
  EXPECT_EQ(read.seed, kept.seed);
}

}  // namespace
}  // namespace wander::test::checkpoint_test
