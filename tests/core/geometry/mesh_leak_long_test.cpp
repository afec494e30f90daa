// Ten million rays at the edges and corners of closed meshes from 1e-6 to 1e6 metres: none escapes.
#include <gtest/gtest.h>

#include "tests/core/geometry/mesh_leaks.h"

namespace wander::test {
namespace {

TEST(ClosedMeshes, LetNoneOfTenMillionRaysOut) {
  const MeshLeaks leaks = count_leaks(7, 5000, 3600, by_hierarchy);
  EXPECT_GT(leaks.rays, 10'000'000);
  EXPECT_EQ(leaks.escaped, 0);
}

}  // namespace
}  // namespace wander::test
