// Large steps that have learned from a seed pass leave f invariant; the control is one that samples
// by what it has learned and claims the uniform density.  False alarms: 1e-9 per decision.
#include <gtest/gtest.h>

#include "mlt/seeds/seed_pass.h"
#include "mutations/primary_large.h"
#include "tests/support/caught.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

PrimaryLarge learned(const Flat& space) {
  SeedSlice<Flat> seeds(space, 1, 0, 1);
  seeds.run(4000);
  PrimaryLarge large(space.max_vertices());
  large.learn(seeds.tally());
  return large;
}

// Claims T(x→y) = Σ_s p_s(y) / ((n + 1) lengths), as if q were uniform.
struct ForgetfulLargeStep {
  static constexpr std::string_view name = PrimaryLarge::name;
  PrimaryLarge large;

  template <class Space>
  double applicability(const Space& space, const Path<Flatland>& x) const {
    return large.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<Flatland>& x, Path<Flatland>& y,
                   Random& random) const {
    const Proposed proposed = large.propose(space, x, y, random);
    if (std::holds_alternative<Failure>(proposed)) return proposed;
    return Proposal{y.intensity / Scaled(y.size() + 1), x.intensity / Scaled(x.size() + 1)};
  }
};

struct Room {
  const char* name;
  description::Scene (*make)();
};
class LearnedLargeStep : public ::testing::TestWithParam<Room> {
 protected:
  FlatScene scene_ = build(GetParam().make());
  Flat space_{*scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Rooms, LearnedLargeStep,
                         ::testing::Values(Room{"Diffuse", diffuse_room},
                                           Room{"MirrorAndGlass", mirror_and_glass},
                                           Room{"Camera", pinhole_room}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(LearnedLargeStep, LeavesTheDistributionOfPathsInvariant) {
  const InvarianceReport report =
      test_invariance(space_, alone(learned(space_)),
                      {.samples = 30'000, .steps = 5, .false_alarm = usual_false_alarm});
  EXPECT_TRUE(passes(report.one_step));
  EXPECT_TRUE(passes(report.many_steps));
  EXPECT_GE(report.many_steps.comparisons, std::size_t{20});
}

TEST_P(LearnedLargeStep, ThatForgetsWhatItLearnedIsCaught) {
  EXPECT_TRUE(
      caught(test_invariance(space_, alone(ForgetfulLargeStep{learned(space_)}),
                             {.samples = 30'000, .steps = 5, .false_alarm = usual_false_alarm})));
}

}  // namespace
}  // namespace wander::test
