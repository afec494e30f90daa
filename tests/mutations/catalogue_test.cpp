// What the catalogue makes of weights and parameters.
#include "mutations/catalogue.h"

#include <gtest/gtest.h>

#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

Family family_of(const MutationWeights& weights, double kernel) {
  return make_family({weights, default_large_step, kernel}, 6);
}

template <class M>
const M& member(const Family& family) {
  return family.get<M>();
}

TEST(Catalogue, TellsWhatCanBeSetAndWhatIsUsual) {
  const std::vector<ParameterFacts> lens = parameters_of("lens");
  ASSERT_EQ(lens.size(), 2u);
  EXPECT_EQ(lens[1].name, "angle");
  EXPECT_EQ(lens[1].smallest, PerturbationRange{}.angle.smallest);
  EXPECT_EQ(lens[1].largest, PerturbationRange{}.angle.largest);
  EXPECT_TRUE(lens[1].is_range());
  EXPECT_TRUE(parameters_of("bidirectional").empty());
  EXPECT_EQ(parameters_of("primary").size(), 1u);
}

TEST(Catalogue, SetsTheParametersOfTheNamedMutationAlone) {
  const Family family = family_of({{"lens", 1, {{"angle", 0.25, 0.5}}}, {"caustic", 1}}, 1);
  EXPECT_EQ(member<Lens>(family).range.angle.smallest, 0.25);
  EXPECT_EQ(member<Lens>(family).range.angle.largest, 0.5);
  EXPECT_EQ(member<Lens>(family).range.position.largest, PerturbationRange{}.position.largest);
  EXPECT_EQ(member<Caustic>(family).range.angle.largest, PerturbationRange{}.angle.largest);
}

TEST(Catalogue, WhatIsSetIsNotScaled) {
  const Family family = family_of({{"lens", 1, {{"angle", 0.25, 0.5}}}}, 2);
  EXPECT_EQ(member<Lens>(family).range.angle.largest, 0.5);
  EXPECT_EQ(member<Lens>(family).range.position.smallest,
            2 * PerturbationRange{}.position.smallest);
}

TEST(Catalogue, WordsShareTheirWeightAsTheirMutationsSay) {
  const Family family = make_family({{{"primary", 2}}, 0.25, 1}, 6);
  EXPECT_EQ(family.weights(), (std::array<double, 6>{0, 0, 0, 0, 2 * 0.75, 2 * 0.25}));
}

}  // namespace
}  // namespace wander::test
