// The mutation of docs/extending.md: it leaves f invariant, and is caught when a factor of its
// density is forgotten.
//
// False alarms: 1e-9 per decision, of which each test makes three.
// extending_test.py puts the same file into the catalogue of a copy of the program.
#include "docs/examples/sensor_slide.h"

#include <gtest/gtest.h>

#include "tests/support/caught.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

// Its density without the size of the window: forward and reverse are then equal.
struct WithoutWindow {
  static constexpr std::string_view name = SensorSlide::name;
  SensorSlide mutation{};

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return mutation.applicability(space, x);
  }
  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    Proposed proposed = mutation.propose(space, x, y, random);
    if (Proposal* p = std::get_if<Proposal>(&proposed)) {
      p->forward *= window(space, x);
      p->reverse *= window(space, y);
    }
    return proposed;
  }

 private:
  template <class Space>
  double window(const Space& space, const Path<typename Space::Universe>& z) const {
    double size = 1;
    for (const auto u : space.end_parameter(z, z.size() - 1)) size *= mutation.window_of(u).size();
    return size;
  }
};

template <class Mutation>
InvarianceReport report_of(description::Scene (*room)(), const Mutation& mutation) {
  const FlatScene scene = build(room());
  return test_invariance(Flat(*scene, Roulette::off), alone(mutation), {.samples = 100'000});
}

TEST(OwnMutation, LeavesTheTargetInvariant) {
  for (const auto room : {diffuse_room, mirror_and_glass, curved_ends, rough_room}) {
    const InvarianceReport report = report_of(room, SensorSlide{});
    EXPECT_TRUE(passes(report.one_step));
    EXPECT_TRUE(passes(report.many_steps));
    EXPECT_TRUE(passes(report.flux));
  }
}

TEST(OwnMutation, WithoutTheSizeOfItsWindowIsCaught) {
  for (const auto room : {diffuse_room, mirror_and_glass, curved_ends, rough_room})
    EXPECT_TRUE(caught(report_of(room, WithoutWindow{})));
}

TEST(OwnMutation, CannotActBeforeACamera) {
  EXPECT_EQ(report_of(pinhole_room, SensorSlide{}).acted, 0u);
}

// What --mutations sensor_slide=1:reach=0.05 does.
TEST(OwnMutation, HasAParameterThatCanBeSet) {
  SensorSlide slide;
  ASSERT_EQ(traits<SensorSlide>.parameters.size(), 1u);
  const Parameter<SensorSlide>& reach = traits<SensorSlide>.parameters.front();
  EXPECT_EQ(reach.name, "reach");
  EXPECT_EQ(reach.ends(slide).smallest, slide.reach);
  reach.set(slide, {0.05, 0.05});
  EXPECT_EQ(slide.reach, 0.05);
}

}  // namespace
}  // namespace wander::test
