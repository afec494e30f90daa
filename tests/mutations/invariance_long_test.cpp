// Invariance and balance of flux with ten times the samples of the quick tests, in every
// room; few of them become paths that the multi-chain perturbation moves, so that it has four times as
// many.  False alarms: 1e-9 per test.
#include <gtest/gtest.h>

#include "tests/support/expect.h"
#include "tests/support/kernel_cases.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

const std::vector<NamedRoom> rooms{
    {"Diffuse", diffuse_room}, {"Gap", room_with_gap},    {"MirrorAndGlass", mirror_and_glass},
    {"Rough", rough_room},     {"Pinhole", pinhole_room}, {"ThinLens", thin_lens_room}};

// There the caustic perturbation moves no path from one coarse cell to another, however many samples
// it has: what it does is seen by invariance alone.
constexpr const char* without_flux = "GapCaustic";

class LongKernel : public ::testing::TestWithParam<RoomKernel> {};

TEST_P(LongKernel, LeavesTheDistributionOfPathsInvariantAndItsFluxBalanced) {
  const auto& [name, make, kernel] = GetParam();
  const FlatScene scene = build(make());
  const Transport<Flatland> space(*scene, Roulette::off);
  const std::uint64_t samples = kernel.name == "Multichain" ? 2'400'000 : 600'000;
  const InvarianceReport report =
      kernel.test(space, {.samples = samples, .seed = 11, .false_alarm = usual_false_alarm / 3});
  EXPECT_TRUE(passes(report.one_step));
  EXPECT_TRUE(passes(report.many_steps));
  const bool moves_nothing = report.flux.detail == nothing_moved;
  EXPECT_EQ(moves_nothing, GetParam().name() == without_flux);
  EXPECT_TRUE(moves_nothing || passes(report.flux));
  RecordProperty("one_step", std::to_string(report.one_step.statistic));
  RecordProperty("many_steps", std::to_string(report.many_steps.statistic));
  RecordProperty("flux", std::to_string(report.flux.statistic));
}

INSTANTIATE_TEST_SUITE_P(Rooms, LongKernel, ::testing::ValuesIn(acting_in(rooms, kernel_cases())),
                         [](const auto& test) { return test.param.name(); });
INSTANTIATE_TEST_SUITE_P(PerturbationRooms, LongKernel,
                         ::testing::ValuesIn(acting_in(perturbation_rooms(), wide_perturbations())),
                         [](const auto& test) { return test.param.name(); });

}  // namespace
}  // namespace wander::test
