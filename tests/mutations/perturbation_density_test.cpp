// The densities that the lens, caustic and multi-chain perturbations claim are those with which
// they propose: to four digits, for moves of random paths, in the plane and in space.
//
// This sees what cancels in an acceptance ratio, where invariance is blind: the constants of the
// kernels, the size of a light, the index of a glass.
#include <gtest/gtest.h>

#include "tests/support/claimed_density.h"
#include "tests/support/invariance.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/perturbation_twins.h"
#include "tests/support/space_box.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

constexpr PerturbationRange wide{.position{1e-3, 0.4}, .angle{1e-3, 0.7}};
constexpr double tolerance = 1e-4;

// How the claims of a mutation compare with the densities of its moves.
struct Comparison {
  int right = 0, wrong = 0;
  double worst = 0;  // relative
  int all() const { return right + wrong; }
};

// Up to `moves` moves from random paths; `flaw(x, y)` spoils the claim by a factor.
template <class W, class Mutation, class Flaw>
Comparison compare(const Transport<W>& space, const Mutation& mutation, const Flaw& flaw,
                   int moves = 200) {
  Starts<Transport<W>> starts(space, 9);
  Rng random(9, Purpose::test, 61);
  const DensityOfMoves<W> density(space);
  Comparison result;
  for (std::uint64_t i = 0; i < 20'000 && result.all() < moves; ++i) {
    if (!(starts.draw(i) > 0)) continue;
    const Path<W>& x = starts.path();
    if (!(mutation.applicability(space, x) > 0)) continue;
    random.start(i);
    Recording<Rng> numbers{random};
    Path<W> y(space.max_vertices());
    const Proposed proposed = mutation.propose(space, x, y, numbers);
    const Proposal* claim = std::get_if<Proposal>(&proposed);
    if (!claim) continue;
    const auto exact = density.of(mutation, x, y, numbers.drawn);
    if (!exact) continue;
    const double error = std::abs(claim->forward.value() * flaw(x, y) / *exact - 1);
    ++(error < tolerance ? result.right : result.wrong);
    result.worst = std::max(result.worst, error);
  }
  return result;
}
template <class W, class Mutation>
Comparison compare(const Transport<W>& space, const Mutation& mutation) {
  return compare(space, mutation, [](const Path<W>&, const Path<W>&) { return 1.0; });
}

::testing::AssertionResult agrees(const Comparison& c, int fewest) {
  if (c.wrong == 0 && c.right >= fewest) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << c.wrong << " of " << c.all() << " claims are wrong, by up to " << c.worst;
}
// Nearly every claim is wrong.
::testing::AssertionResult differs(const Comparison& c) {
  if (c.all() >= 50 && c.wrong > 0.9 * c.all()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "only " << c.wrong << " of " << c.all() << " are wrong";
}

class ClaimsInThePlane : public ::testing::TestWithParam<NamedRoom> {
 protected:
  FlatScene scene_ = build(GetParam().make());
  Transport<Flatland> space_{*scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Rooms, ClaimsInThePlane, ::testing::ValuesIn(perturbation_rooms()),
                         [](const auto& test) { return test.param.name; });

TEST_P(ClaimsInThePlane, AreTheDensitiesOfTheMoves) {
  EXPECT_TRUE(agrees(compare(space_, Lens{wide}), 100));
  EXPECT_TRUE(agrees(compare(space_, Caustic{wide}), 100));
  const bool acts = Multichain::left_out(requires_of(GetParam().make())).empty();
  EXPECT_TRUE(agrees(compare(space_, Multichain{wide}), acts ? 15 : 0));
}

class ClaimsInSpace : public ::testing::TestWithParam<double> {
 protected:
  Scene<Spaceland> scene_{GetParam() < 0 ? space_box() : space_box_by_camera(GetParam())};
  Transport<Spaceland> space_{scene_, Roulette::off};
};
// The radius of a lens; negative: the sensor is the floor.
INSTANTIATE_TEST_SUITE_P(Sensors, ClaimsInSpace, ::testing::Values(-1.0, 0.0, 0.05));

TEST_P(ClaimsInSpace, AreTheDensitiesOfTheMoves) {
  EXPECT_TRUE(agrees(compare(space_, Lens{wide}), 100));
  EXPECT_TRUE(agrees(compare(space_, Caustic{wide}), 100));
  EXPECT_TRUE(agrees(compare(space_, Multichain{wide}), 15));
}

// ---- wrong twins

template <class W>
double turned_by(const Path<W>& x, const Path<W>& y, int i, Toward toward) {
  const int edge = toward == Toward::sensor ? i : i - 1;
  return std::acos(std::min(1.0, glm::dot(x[edge].place.to_sensor, y[edge].place.to_sensor)));
}

TEST(WrongClaim, WithoutTheSizeOfAnEndIsCaught) {
  const FlatScene scene = build(curved_ends());
  const Transport<Flatland> space(*scene, Roulette::off);
  EXPECT_TRUE(differs(compare(space, In<Lens, WithoutEndDensity>{{wide}})));
}

// Air to air around beads of glass: every index comes in a pair with 1, and only the claim shows
// it.
TEST(WrongClaim, WithoutTheSpreadOfTheIndexIsCaught) {
  const FlatScene scene = build(sensor_in_glass());
  const Transport<Flatland> space(*scene, Roulette::off);
  const Comparison claims = compare(space, In<Caustic, WithoutIndexSpread>{{wide}});
  EXPECT_GT(claims.wrong, 20);
}

TEST(WrongClaim, OfAKernelOfSpaceInThePlaneIsCaught) {
  const FlatScene scene = build(diffuse_room());
  const Transport<Flatland> space(*scene, Roulette::off);
  const auto spatial = [](const Path<Flatland>& x, const Path<Flatland>& y) {
    const int end = x.size() - 1;
    return 1 / (std::numbers::pi * std::sin(turned_by(x, y, end, Toward::light)));
  };
  EXPECT_TRUE(differs(compare(space, Lens{wide}, spatial)));
}

TEST(WrongClaim, WithoutTheSineOfAConeIsCaught) {
  const Scene<Spaceland> scene(space_box());
  const Transport<Spaceland> space(scene, Roulette::off);
  const auto small_angle = [](const Path<Spaceland>& x, const Path<Spaceland>& y) {
    const double angle = turned_by(x, y, x.size() - 1, Toward::light);
    return std::sin(angle) / angle;
  };
  const PerturbationRange far{.position{1e-3, 0.4}, .angle{0.1, 0.7}};
  EXPECT_TRUE(differs(compare(space, Lens{far}, small_angle)));
}

TEST(WrongClaim, WithoutACosineOrWithOneDistanceLessIsCaught) {
  const Scene<Spaceland> scene(space_box());
  const Transport<Spaceland> space(scene, Roulette::off);
  EXPECT_TRUE(differs(compare(space, In<Lens, WithoutCosine>{{wide}})));
  EXPECT_TRUE(differs(compare(space, In<Caustic, WithOneDistanceLess>{{wide}})));
}

}  // namespace
}  // namespace wander::test
