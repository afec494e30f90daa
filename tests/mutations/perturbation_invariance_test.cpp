// The lens, caustic and multi-chain perturbations, each alone and with ranges that reach across a
// room, leave f invariant and balance its flux, in rooms that exercise them: glass around lamp and
// sensor, curves, chains of specular vertices, lenses.  Where one cannot act, it says so.
//
// False alarms: 1e-9 per test, shared by its three decisions; perturbation_twins_test.cpp shows
// that so many samples suffice to see most flaws, and how many the others take.
#include <gtest/gtest.h>

#include "mutations/catalogue.h"
#include "tests/support/expect.h"
#include "tests/support/kernel_cases.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// A mutation that acts on few paths may move too few of them between cells for a decision; the long
// test, which has samples enough, asks for one in every room.
bool is_too_thin(const Decision& flux) { return flux.detail == nothing_moved; }

class Perturbed : public ::testing::TestWithParam<RoomKernel> {};

TEST_P(Perturbed, PathsKeepTheirDistributionAndFluxIsBalanced) {
  const auto& [name, make, kernel] = GetParam();
  const FlatScene scene = build(make());
  // Few paths are made for the multi-chain perturbation.
  const std::uint64_t samples = kernel.name == "Multichain" ? 120'000 : 30'000;
  const InvarianceOptions options{
      .samples = samples, .steps = 10, .seed = 3, .false_alarm = usual_false_alarm / 3};
  const InvarianceReport report = kernel.test(Flat(*scene, Roulette::off), options);
  EXPECT_TRUE(passes(report.one_step));
  EXPECT_TRUE(passes(report.many_steps));
  EXPECT_TRUE(is_too_thin(report.flux) || passes(report.flux)) << describe(report.flux);
  EXPECT_GE(report.many_steps.comparisons, kernel.fewest_comparisons);
}

INSTANTIATE_TEST_SUITE_P(Rooms, Perturbed,
                         ::testing::ValuesIn(acting_in(perturbation_rooms(), wide_perturbations())),
                         [](const auto& test) { return test.param.name(); });

// ---- where a mutation cannot act

// Whether it is applicable to `x`; if it is not, it proposes nothing and a chain stays where it is.
template <class Mutation>
double applicability(const Flat& space, const Mutation& mutation, const Path<W>& x, Rng& random) {
  const double applies = mutation.applicability(space, x);
  const auto kernel = alone(mutation);
  Chain chain(space, kernel, x);
  chain.step(random, [&](const Step<W>& step) {
    EXPECT_EQ(applies > 0, step.reason != Reason::not_applicable) << path_class(x);
    if (applies > 0) return;
    EXPECT_EQ(step.acceptance, 0);
    Path<W> y(space.max_vertices());
    const Proposed proposed = mutation.propose(space, x, y, random);
    EXPECT_TRUE(std::holds_alternative<Failure>(proposed)) << path_class(x);
  });
  return applies;
}

// Calls check(space, x, random) for states of a room.
template <class Check>
void for_states(description::Scene (*make)(), const Check& check) {
  const FlatScene scene = build(make());
  const Flat space(*scene, Roulette::off);
  Starts<Flat> starts(space, 5);
  Rng random(5, Purpose::test, 60);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    random.start(i);
    if (starts.draw(i) > 0) check(space, starts.path(), random);
  }
}

TEST(Applicability, OfTheMultiChainPerturbationIsZeroWhereNothingIsSpecular) {
  for (const auto make : {diffuse_room, rough_room, room_with_gap}) {
    EXPECT_FALSE(Multichain::left_out(requires_of(make())).empty());
    for_states(make, [](const Flat& space, const Path<W>& x, Rng& random) {
      EXPECT_EQ(applicability(space, Multichain{}, x, random), 0);
    });
  }
}

// By the letters of a path alone, the ends of which are E S* D: the neighbour of that D, or of the
// D before the next S*, decides.
TEST(Applicability, IsAMatterOfTheClassOfAPath) {
  int lens = 0, multichain = 0;
  for (const NamedRoom& room : perturbation_rooms()) {
    for_states(room.make, [&](const Flat& space, const Path<W>& x, Rng& random) {
      const std::string letters = path_class(x);
      const std::size_t d = letters.find_last_not_of('S', letters.size() - 2);
      const bool specular_behind = d > 0 && letters[d - 1] == 'S';
      EXPECT_EQ(applicability(space, Lens{}, x, random), specular_behind ? 0 : 1) << letters;
      EXPECT_EQ(applicability(space, Multichain{}, x, random), specular_behind ? 1 : 0) << letters;
      const bool hits_sensor = letters.size() == 2 || letters[letters.size() - 2] == 'S';
      EXPECT_EQ(applicability(space, Caustic{}, x, random),
                hits_sensor && !space.sensor_can_be_hit() ? 0 : 1)
          << letters;
      ++(specular_behind ? multichain : lens);
    });
  }
  EXPECT_GT(lens, 1000);
  EXPECT_GT(multichain, 300);
}

}  // namespace
}  // namespace wander::test
