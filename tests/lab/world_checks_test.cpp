// Each mutation leaves f invariant in single precision, too, and at the ends of its dials: with
// moves a hundred times as short and ten times as long, as short and as long as an adaptation may choose
// them, and large steps that are rare or frequent.
//
// False alarms: 1e-9 per check, shared by its decisions.
#include "lab/engine.h"

#include <gtest/gtest.h>

#include "mlt/run/adaptation.h"
#include "scenes/format/build_scene.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/test_scenes.h"
#include "tests/support/wrong_twins.h"

namespace wander::test {
namespace {

constexpr InvarianceOptions options{
    .samples = 10'000, .steps = 8, .seed = 7, .false_alarm = usual_false_alarm / 30};

// How many of the kernels could be told to be right; none may be wrong.
int passed(const description::Scene& scene, const Dials& dials) {
  Session session;
  session.threads = 2;
  int count = 0;
  check_mutations(
      {scene, find_method("mlt"), dials}, options, Run(session), [&](const KernelCheck& check) {
        const Verdict verdict = verdict_of(check.report);
        EXPECT_NE(verdict, Verdict::failed)
            << check.name << " in " << scene.name << ": " << describe(check.report.one_step)
            << describe(check.report.many_steps) << describe(check.report.flux);
        count += verdict == Verdict::passed ? 1 : 0;
      });
  return count;
}

class InFloat : public ::testing::TestWithParam<NamedRoom> {};
INSTANTIATE_TEST_SUITE_P(Rooms, InFloat,
                         ::testing::Values(NamedRoom{"Diffuse", diffuse_room},
                                           NamedRoom{"MirrorAndGlass", mirror_and_glass},
                                           NamedRoom{"Rough", rough_room},
                                           NamedRoom{"ThinLens", thin_lens_room}),
                         [](const auto& test) { return test.param.name; });

TEST_P(InFloat, EveryMutationAndTheirMixtureLeaveTheTargetInvariant) {
  EXPECT_GE(passed(GetParam().make(), {.precision = Precision::of_float}), 4);
}

TEST(InFloat, AnInvertedRatioIsCaught) {
  const auto scene = build_flatland<FlatlandSingle>(diffuse_room());
  const Transport<FlatlandSingle> space(*scene, Roulette::off);
  const auto twin = alone(FlawedRatio<Bidirectional>{{}, RatioFlaw::inverted});
  EXPECT_TRUE(rejects(test_invariance(space, twin, options).many_steps));
}

TEST(ShortAndLongMoves, LeaveTheTargetInvariant) {
  const MutationWeights small{{"lens", 1}, {"caustic", 1}, {"multichain", 1}, {"primary", 1}};
  for (const auto make : {mirror_and_glass, rough_room}) {
    for (const double kernel : {0.01, smallest_kernel, 10.0, largest_kernel}) {
      // The shortest change some functions of few paths alone.
      const int fewest = kernel < 1 ? 2 : 3;
      EXPECT_GE(passed(make(), {.mutations = small, .kernel = kernel}), fewest) << kernel;
      const Dials single{.mutations = small, .precision = Precision::of_float, .kernel = kernel};
      EXPECT_GE(passed(make(), single), fewest) << kernel;
    }
  }
}

TEST(RareAndFrequentLargeSteps, LeaveTheTargetInvariant) {
  for (const double large : {0.01, 0.99}) {
    for (const Precision precision : precisions) {
      const Dials dials{.mutations = {{"primary", 1}}, .precision = precision, .large_step = large};
      EXPECT_EQ(passed(diffuse_room(), dials), 3) << large << ", " << name_of(precision);
    }
  }
}

}  // namespace
}  // namespace wander::test
