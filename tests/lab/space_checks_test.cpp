// Each mutation leaves the target invariant and balances its flux in space, in colour and in one
// channel, among meshes, triangles, glass and tinted metal, as a lens or a sensor sees them.
//
// False alarms: 1e-9 per check, shared by its decisions.
#include <gtest/gtest.h>

#include "lab/engine.h"
#include "scenes/format/build_scene.h"
#include "tests/support/coloured_box.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/wrong_twins.h"

namespace wander::test {
namespace {

constexpr InvarianceOptions options{
    .samples = 8'000, .steps = 20, .seed = 3, .false_alarm = usual_false_alarm / 30};

// How many of the kernels could be told to be right; none may be wrong.
int passed(const description::Scene& scene) {
  Session session;
  session.threads = 2;
  int count = 0;
  check_mutations({scene, find_method("mlt"), {}}, options, Run(session),
                  [&](const KernelCheck& check) {
                    const Verdict verdict = verdict_of(check.report);
                    EXPECT_NE(verdict, Verdict::failed)
                        << check.name << ": " << describe(check.report.one_step)
                        << describe(check.report.many_steps) << describe(check.report.flux);
                    count += verdict == Verdict::passed ? 1 : 0;
                  });
  return count;
}

description::Scene seen_by_its_floor(description::Scene scene) {
  scene.camera.reset();
  scene.shapes[0].sensor = description::Sensor{{4, 3}};
  return scene;
}

// Of seven, six mutations and their mixture; few paths are made for one of them.
TEST(ChecksInColour, PassBehindALens) {
  description::Scene scene = box_with_mesh();
  scene.camera->aperture_radius = 0.03;
  EXPECT_GE(passed(scene), 6);
}
TEST(ChecksInColour, PassOnASensor) { EXPECT_GE(passed(seen_by_its_floor(box_with_mesh())), 6); }
TEST(ChecksInOneChannel, PassOnASensorAmongMeshes) {
  EXPECT_GE(passed(seen_by_its_floor(channel_of(box_with_mesh(), 0))), 6);
}

TEST(ChecksInColour, CatchAnInvertedRatio) {
  const auto scene = build_scene<SpacelandColour>(box_with_mesh());
  const Transport<SpacelandColour> space(*scene, Roulette::off);
  const auto twin = alone(FlawedRatio<PrimarySmall>{{}, RatioFlaw::inverted});
  EXPECT_TRUE(rejects(test_invariance(space, twin, options).many_steps));
}

}  // namespace
}  // namespace wander::test
