// What runs of a million bins say that they need, and take.
#include "tests/lab/memory_of_runs.h"

namespace wander::test {
namespace {

using MemoryOfLargeRuns = MemoryOfRuns;

TEST_F(MemoryOfLargeRuns, IsBetweenHalfOfWhatTheySayAndTheWhole) {
  expect_between_half_and_the_whole({{"bdpt", 1'000'000, "--by-length"},
                                     {"mlt", 1'000'000},
                                     {"mlt", 1'000'000, "--by-length --maps"},
                                     {"pssmlt", 1'000'000},
                                     {"mmlt", 1'000'000}});
}

}  // namespace
}  // namespace wander::test
