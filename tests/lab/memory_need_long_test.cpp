// As memory_need_test.cpp, of more methods, and of a million bins.
#include "tests/lab/memory_of_runs.h"

namespace wander::test {
namespace {

using MemoryOfLargeRuns = MemoryOfRuns;

TEST_F(MemoryOfLargeRuns, IsBetweenHalfOfWhatTheySayAndTheWhole) {
  expect_between_half_and_the_whole({{"bdpt", 16'000},
                                     {"pssmlt", 16'000},
                                     {"pt", 1'000'000},
                                     {"bdpt", 1'000'000, "--by-length"},
                                     {"mlt", 1'000'000},
                                     {"mlt", 1'000'000, "--by-length --maps"},
                                     {"pssmlt", 1'000'000},
                                     {"mmlt", 1'000'000},
                                     {"mmlt", 100, "", 60},
                                     // A chain begins with its first step: these are 19136.
                                     {"mmlt", 100, "", 300, "500k"}});
}

}  // namespace
}  // namespace wander::test
