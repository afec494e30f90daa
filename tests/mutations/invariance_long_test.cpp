// Invariance and balance of flux with ten times the samples of the quick tests, in every
// room.  False alarms: 1e-7 per test.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/expect.h"
#include "tests/support/kernel_cases.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

class LongKernel : public ::testing::TestWithParam<std::tuple<int, KernelCase>> {};

TEST_P(LongKernel, LeavesTheDistributionOfPathsInvariantAndItsFluxBalanced) {
  const auto& [room, kernel] = GetParam();
  const FlatScene scene = build(lit_scenes()[static_cast<std::size_t>(room)].scene);
  const Transport<Flatland> space(*scene, Roulette::off);
  const InvarianceReport report =
      kernel.test(space, {.samples = 600'000, .seed = 11, .false_alarm = usual_false_alarm / 3});
  EXPECT_TRUE(passes(report.one_step));
  EXPECT_TRUE(passes(report.many_steps));
  EXPECT_TRUE(passes(report.flux));
  RecordProperty("one_step", std::to_string(report.one_step.statistic));
  RecordProperty("many_steps", std::to_string(report.many_steps.statistic));
  RecordProperty("flux", std::to_string(report.flux.statistic));
}

INSTANTIATE_TEST_SUITE_P(Rooms, LongKernel,
                         ::testing::Combine(::testing::Range(0,
                                                             static_cast<int>(lit_scenes().size())),
                                            ::testing::ValuesIn(kernel_cases())),
                         [](const auto& test) {
                           std::string name =
                               lit_scenes()[static_cast<std::size_t>(std::get<0>(test.param))].name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name + "_" + std::get<1>(test.param).name;
                         });

}  // namespace
}  // namespace wander::test
