// As symmetries_test.cpp, in space with colour: triangles, spheres, a mirror and glass; and a lens before meshes.
#include "tests/lab/expected_symmetries.h"

namespace wander::test {
namespace {

TEST(SymmetriesInColour, OfARoomWithGlass) {
  const description::Scene scene = scene_named("cornell-glass");
  expect_symmetries(scene, variations_of(scene));
}
TEST(SymmetriesInColour, OfMeshesBehindALens) {
  const description::Scene scene = ring_behind_a_lens();
  expect_symmetries(scene, variations_of(scene));
}

}  // namespace
}  // namespace wander::test
