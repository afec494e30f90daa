// Detailed balance of each mutation: between any two cells of paths, of film by length by light, as
// much weight flows one way as the other in a single step.
//
// The flux sees what invariance hardly sees: flaws that shift probability around in circles.
#include <gtest/gtest.h>

#include "mutations/catalogue.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/test_scenes.h"
#include "tests/support/wrong_twins.h"

namespace wander::test {
namespace {

template <class Kernel>
Decision flux(const Scene<Flatland>& scene, const Kernel& kernel, std::uint64_t samples) {
  const Transport<Flatland> space(scene, Roulette::off);
  return test_invariance(space, kernel, {.samples = samples, .steps = 1}).flux;
}

class Flow : public ::testing::TestWithParam<description::Scene (*)()> {
 protected:
  FlatScene scene_ = build(GetParam()());
};

TEST_P(Flow, OfTheBidirectionalMutationIsBalanced) {
  const Decision balance = flux(*scene_, alone(Bidirectional{}), 100'000);
  EXPECT_TRUE(passes(balance));
  EXPECT_GE(balance.comparisons, std::size_t{2});
}
TEST_P(Flow, OfTheSmallStepIsBalanced) {
  EXPECT_TRUE(passes(flux(*scene_, alone(PrimarySmall{}), 100'000)));
}
TEST_P(Flow, OfTheLargeStepIsBalanced) {
  const Decision balance = flux(*scene_, alone(PrimaryLarge(scene_->max_vertices())), 100'000);
  EXPECT_TRUE(passes(balance));
  EXPECT_GE(balance.comparisons, std::size_t{2});
}
TEST_P(Flow, OfTheFamilyIsBalanced) {
  EXPECT_TRUE(passes(flux(*scene_, make_family({}, scene_->max_vertices()), 100'000)));
}

INSTANTIATE_TEST_SUITE_P(Rooms, Flow, ::testing::Values(diffuse_room, mirror_and_glass),
                         [](const auto& test) {
                           return test.param == diffuse_room ? "Diffuse" : "MirrorAndGlass";
                         });

TEST(WrongFlow, OfFlawedRatiosIsCaught) {
  const FlatScene scene = build(diffuse_room());
  for (const RatioFlaw flaw : {RatioFlaw::symmetric, RatioFlaw::inverted, RatioFlaw::threshold}) {
    SCOPED_TRACE(static_cast<int>(flaw));
    const FlawedRatio<Bidirectional> twin{{}, flaw};
    EXPECT_TRUE(rejects(flux(*scene, alone(twin), 100'000)));
  }
}

TEST(WrongFlow, OfAForgottenDeletionAndOfASingleSplitIsCaught) {
  const FlatScene scene = build(diffuse_room());
  for (const auto flaw : {BidirectionalFlaw::no_deletion, BidirectionalFlaw::single_split}) {
    SCOPED_TRACE(static_cast<int>(flaw));
    EXPECT_TRUE(rejects(flux(*scene, alone(FlawedBidirectional{flaw}), 100'000)));
  }
}

TEST(WrongFlow, OfALargeStepWithoutTheIntensityIsCaught) {
  const FlatScene scene = build(diffuse_room());
  const LargeStepWithoutIntensity twin{PrimaryLarge(scene->max_vertices())};
  EXPECT_TRUE(rejects(flux(*scene, alone(twin), 100'000)));
}

}  // namespace
}  // namespace wander::test
