// Wrong twins of the perturbations, one flaw each, caught by invariance (after one step or ten) or
// by the balance of flux; and the same texts without a flaw, which pass.
//
// A factor that is the same for x and y cancels in the ratio, and no chain can show it: kernels
// with a wrong constant, or the size of a light.  perturbation_density_test.cpp catches those.
// False alarms: 1e-9 per decision.
#include <gtest/gtest.h>

#include "tests/support/caught.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/perturbation_twins.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;
using Room = description::Scene (*)();

constexpr PerturbationRange wide{.position{1e-3, 0.4}, .angle{1e-3, 0.7}};
// For flaws that show in long moves.
constexpr PerturbationRange far{.position{0.05, 0.9}, .angle{0.05, 1.3}};

template <class Kernel>
InvarianceReport report_of(Room room, const Kernel& kernel, std::uint64_t samples = 30'000) {
  const FlatScene scene = build(room());
  return test_invariance(Flat(*scene, Roulette::off), kernel, {.samples = samples, .steps = 10});
}

template <class Mutation>
::testing::AssertionResult caught(Room room, const Mutation& mutation,
                                  std::uint64_t samples = 30'000) {
  return test::caught(report_of(room, alone(mutation), samples));
}

TEST(PerturbationTwin, WithoutAFlawPasses) {
  EXPECT_TRUE(passes(report_of(diffuse_room, alone(In<Lens, Faithful>{{wide}})).many_steps));
  EXPECT_TRUE(passes(report_of(diffuse_room, alone(In<Caustic, Faithful>{{wide}})).many_steps));
  EXPECT_TRUE(
      passes(report_of(mirror_corridor, alone(In<Multichain, Faithful>{{wide}})).many_steps));
}

TEST(PerturbationTwin, WithoutTheCosineAtATurnedDirectionIsCaught) {
  EXPECT_TRUE(caught(diffuse_room, In<Lens, WithoutCosine>{{wide}}));
  EXPECT_TRUE(caught(diffuse_room, In<Caustic, WithoutCosine>{{wide}}));
  EXPECT_TRUE(caught(mirror_corridor, In<Multichain, WithoutCosine>{{wide}}));
}

TEST(PerturbationTwin, WithADensityOfDirectionsForOneOfAreaIsCaught) {
  EXPECT_TRUE(caught(pinhole_room, In<Lens, WithoutGeometry>{{far}}, 100'000));
  EXPECT_TRUE(caught(diffuse_room, In<Caustic, WithoutGeometry>{{far}}));
  EXPECT_TRUE(caught(mirror_corridor, In<Multichain, WithoutGeometry>{{far}}));
}

TEST(PerturbationTwin, WithoutTheCosineOfAFilmIsCaught) {
  EXPECT_TRUE(caught(pinhole_room, In<Lens, WithoutFilmSpread>{{far}}, 100'000));
  EXPECT_TRUE(caught(thin_lens_room, In<Lens, WithoutFilmSpread>{{far}}, 100'000));
}

TEST(PerturbationTwin, ClampedAtAnEdgeIsCaught) {
  EXPECT_TRUE(caught(pinhole_room, Clamped<Lens>{{wide}}));
  EXPECT_TRUE(caught(diffuse_room, Clamped<Lens>{{wide}}));
  EXPECT_TRUE(caught(diffuse_room, Clamped<Caustic>{{wide}}));
}

TEST(PerturbationTwin, WithOneSideHalfAsLikelyIsCaught) {
  EXPECT_TRUE(caught(pinhole_room, By<Lens, Lopsided>{{wide}}));
  EXPECT_TRUE(caught(diffuse_room, By<Caustic, Lopsided>{{wide}}));
  EXPECT_TRUE(caught(mirror_corridor, By<Multichain, Lopsided>{{wide}}));
}

TEST(PerturbationTwin, WithARangeOfThePathIsCaught) {
  EXPECT_TRUE(caught(diffuse_room, RangeOfThePath<Caustic>{}));
  EXPECT_TRUE(caught(diffuse_room, RangeOfThePath<Lens>{}));
}

TEST(PerturbationTwin, WithLobesThatChangeWithoutAProbabilityIsCaught) {
  EXPECT_TRUE(caught(sensor_across_the_surface, WithLobesByCoin<Lens>{{far}}));
  EXPECT_TRUE(caught(sensor_across_the_surface, WithLobesByCoin<Caustic>{{far}}));
}

// Where one chain enters one glass and its neighbour another, or the sensor is in both media.
TEST(PerturbationTwin, WithoutTheSpreadOfTheIndexIsCaught) {
  EXPECT_TRUE(caught(beads_of_two_glasses, In<Lens, WithoutIndexSpread>{{wide}}));
  EXPECT_TRUE(caught(beads_of_two_glasses, In<Caustic, WithoutIndexSpread>{{wide}}));
}

TEST(PerturbationTwin, ThatConnectsSpecularVerticesIsCaught) {
  EXPECT_TRUE(caught(mirror_and_glass, In<Lens, ConnectingAnything>{{wide}}));
  EXPECT_TRUE(caught(mirror_and_glass, In<Caustic, ConnectingAnything>{{wide}}));
}

// The bidirectional mutation changes the class of a path, and with it what is applicable.
TEST(PerturbationTwin, OfAMixtureWithAStaleSelectionIsCaught) {
  using Three = Mixture<Bidirectional, Lens, Multichain>;
  const Three mixture({1, 3, 0.1}, {}, Lens{wide}, Multichain{wide});
  EXPECT_TRUE(passes(report_of(mirror_corridor, mixture).many_steps));
  EXPECT_TRUE(test::caught(report_of(mirror_corridor, StaleSelection<Three>{mixture}, 100'000)));
}

}  // namespace
}  // namespace wander::test
