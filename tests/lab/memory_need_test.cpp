// What a run says that it needs is held against what the program takes; and a run that would not
// fit says so.  Of large films memory_need_long_test.cpp has more.
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "lab/packing.h"
#include "tests/lab/memory_of_runs.h"

namespace wander::test {
namespace {

TEST_F(MemoryOfRuns, IsBetweenHalfOfWhatTheySayAndTheWhole) {
  expect_between_half_and_the_whole({{"bdpt", 100},
                                     {"mlt", 100},
                                     {"mlt", 16'000},
                                     {"mmlt", 16'000},
                                     {"mlt", 300'000, "--by-length --maps"}});
}

TEST_F(MemoryOfRuns, ThatWouldNotFitIsRefusedBeforeTheyBegin) {
  write_box({"mlt", 10'000'000});
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
  for (int kilobytes = 120'000; kilobytes < 180'000; kilobytes += 3'000) {
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

// A state that is whole is not called damaged for want of memory.
TEST_F(MemoryOfRuns, ThatTheStateOfARunHasNotIsSaid) {
  for (const char* seed : {"1", "2"})
    ASSERT_EQ(wander(std::string("render box.json -m mlt -b 20k -q -s ") + seed + " -o run-" + seed)
                  .exit_code,
              0);
  int refused = 0;
  for (int kilobytes = 100'000; kilobytes < 180'000; kilobytes += 2'000) {
    const std::string limited = "ulimit -v " + std::to_string(kilobytes) + "; \"$WANDER\" ";
    if (shell(limited + "--version").exit_code != 0) continue;  // its libraries need more
    const Outcome outcome = shell(limited + "merge run-1 run-2 -t 1 -q -o both --force");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
        << outcome.exit_code << outcome.err;
    if (outcome.exit_code == 0) continue;
    EXPECT_HAS(outcome.err, "memory");
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

// In a process in which there is no block of 16 kB left: what unpacks asks for more by itself.
[[noreturn]] void unpack_without_memory(std::string_view frame, std::uint64_t size) {
  const rlimit none{1, 1};
  setrlimit(RLIMIT_AS, &none);
  static std::atomic<void*> block;  // that the compiler leaves them all in
  do {
    block = std::malloc(1 << 14);
  } while (block);
  int code = 0;
  try {
    code = unpacked(frame, size) ? 3 : 4;
  } catch (const std::bad_alloc&) {
    code = 5;
  }
  std::_Exit(code);
}
TEST(MemoryOfStates, IsAskedForWhereTheyAreUnpacked) {
  std::string frame;
  const ByteSink sink = [&frame](std::string_view part) { frame += part; };
  Packing packing(sink);
  packing.add("a state");
  packing.end();
  ASSERT_EQ(unpacked(frame, 7), "a state");
  EXPECT_EXIT(unpack_without_memory(frame, 7), ::testing::ExitedWithCode(5), "");
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
