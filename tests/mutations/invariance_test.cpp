// Each mutation alone, and their mixture, leaves f invariant: after one step and after twenty, in
// rooms of diffuse walls, mirrors and glass, rough surfaces, and before a camera.
//
// False alarms: 1e-9 per test, shared by its decisions; each of those is over about fifty
// functions. The wrong twins show that the samples suffice to see a flaw.
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/kernel_cases.h"
#include "tests/support/test_scenes.h"
#include "tests/support/wrong_twins.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

const std::vector<NamedRoom> rooms{{"Diffuse", diffuse_room},
                                   {"MirrorAndGlass", mirror_and_glass},
                                   {"Rough", rough_room},
                                   {"Camera", pinhole_room}};

class Kernel : public ::testing::TestWithParam<RoomKernel> {};

TEST_P(Kernel, LeavesTheDistributionOfPathsInvariant) {
  const auto& [name, make, kernel] = GetParam();
  const FlatScene scene = build(make());
  // Few paths are made for the multi-chain perturbation.
  const std::uint64_t samples = kernel.name == "Multichain" ? 60'000 : 35'000;
  const InvarianceOptions options{
      .samples = samples, .steps = 10, .false_alarm = usual_false_alarm / 2};
  const InvarianceReport report = kernel.test(Flat(*scene, Roulette::off), options);
  EXPECT_TRUE(passes(report.one_step));
  EXPECT_TRUE(passes(report.many_steps));
  EXPECT_GE(report.many_steps.comparisons, kernel.fewest_comparisons);
}

INSTANTIATE_TEST_SUITE_P(Rooms, Kernel, ::testing::ValuesIn(acting_in(rooms, kernel_cases())),
                         [](const auto& test) { return test.param.name(); });

// ---- wrong twins

template <class Mutation>
InvarianceReport in_room(description::Scene (*room)(), const Mutation& mutation,
                         std::uint64_t samples = 20'000) {
  const FlatScene scene = build(room());
  return test_invariance(Flat(*scene, Roulette::off), alone(mutation),
                         {.samples = samples, .steps = 10});
}

TEST(WrongTwin, TheTwinWithoutAFlawPasses) {
  const FlawedSmallStep<Kelemen> small{{}, SmallStepFlaw::none};
  EXPECT_TRUE(passes(in_room(diffuse_room, small).many_steps));
}

TEST(WrongTwin, SymmetricMetropolisIsCaught) {
  const FlawedRatio<Bidirectional> twin{{}, RatioFlaw::symmetric};
  const InvarianceReport report = in_room(diffuse_room, twin);
  EXPECT_TRUE(rejects(report.one_step));
  EXPECT_TRUE(rejects(report.many_steps));
}

TEST(WrongTwin, AnInvertedRatioIsCaught) {
  const FlawedRatio<Bidirectional> twin{{}, RatioFlaw::inverted};
  const InvarianceReport report = in_room(diffuse_room, twin);
  EXPECT_TRUE(rejects(report.one_step));
  EXPECT_TRUE(rejects(report.many_steps));
}

TEST(WrongTwin, AThresholdOfTheAcceptanceIsCaught) {
  const FlawedRatio<Bidirectional> twin{{}, RatioFlaw::threshold};
  EXPECT_TRUE(rejects(in_room(diffuse_room, twin).many_steps));
}

TEST(WrongTwin, AForgottenGeometryTermIsCaught) {
  const FlawedBidirectional twin{BidirectionalFlaw::no_geometry};
  EXPECT_TRUE(rejects(in_room(room_with_gap, twin).many_steps));
}

TEST(WrongTwin, AForgottenCosineIsCaught) {
  const FlawedBidirectional twin{BidirectionalFlaw::one_cosine};
  EXPECT_TRUE(rejects(in_room(diffuse_room, twin).many_steps));
}

TEST(WrongTwin, ForgottenProbabilitiesOfDeletionAndSplitAreCaught) {
  const FlawedBidirectional deletion{BidirectionalFlaw::no_deletion};
  EXPECT_TRUE(rejects(in_room(diffuse_room, deletion).many_steps));
  const FlawedBidirectional split{BidirectionalFlaw::no_split};
  EXPECT_TRUE(rejects(in_room(diffuse_room, split).many_steps));
}

TEST(WrongTwin, ASingleSplitIsCaught) {
  const FlawedBidirectional twin{BidirectionalFlaw::single_split};
  EXPECT_TRUE(rejects(in_room(diffuse_room, twin).many_steps));
}

TEST(WrongTwin, ASmallStepWithoutWeightsIsCaught) {
  const FlawedSmallStep<Kelemen> twin{{}, SmallStepFlaw::no_weights};
  EXPECT_TRUE(rejects(in_room(mirror_and_glass, twin, 35'000).many_steps));
}

TEST(WrongTwin, ALargeStepWithoutTheIntensityIsCaught) {
  const LargeStepWithoutIntensity twin{PrimaryLarge(diffuse_room().max_vertices)};
  const InvarianceReport report = in_room(diffuse_room, twin);
  EXPECT_TRUE(rejects(report.one_step));
  EXPECT_TRUE(rejects(report.many_steps));
}

}  // namespace
}  // namespace wander::test
