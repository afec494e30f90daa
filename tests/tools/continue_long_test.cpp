// A hundred kills at random moments.
#include "tests/tools/killed_runs.h"

namespace wander::test {
namespace {

class Killed : public KilledRuns {};

TEST_F(Killed, AHundredTimesItHasTheSameBits) {
  for (const char* method : {"pt", "bdpt", "mlt", "pssmlt", "mmlt"})
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      expect_same_after_kills(method, "2M", 4, seed);
}

}  // namespace
}  // namespace wander::test
