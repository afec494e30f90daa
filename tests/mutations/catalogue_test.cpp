// What the catalogue makes of weights and parameters.
#include "mutations/catalogue.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

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

TEST(Catalogue, TellsTheWeightOfEachWord) {
  EXPECT_EQ(auto_weight_of("bidirectional"), 0.5);
  EXPECT_EQ(auto_weight_of("lens"), 1);
  EXPECT_EQ(auto_weight_of("primary"), primary_auto_weight);
  EXPECT_EQ(auto_weight_of("none"), 0);
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

// Each mutation that a scene can use, once; primary steps share a word and its weight.
TEST(Catalogue, ChoosesWhatASceneCanUse) {
  Requirements scene;
  scene.scatters = true;
  scene.max_vertices = 6;
  const auto words = [](const MutationChoice& choice) {
    std::vector<std::pair<std::string, double>> all;
    for (const MutationWeight& each : choice.weights) all.push_back({each.word, each.weight});
    return all;
  };
  using Words = std::vector<std::pair<std::string, double>>;
  const MutationChoice diffuse = choose_mutations(scene);
  EXPECT_EQ(diffuse.taken,
            (std::vector<std::string>{"bidirectional", "lens", "primary_small", "primary_large"}));
  EXPECT_EQ(words(diffuse),
            (Words{{"bidirectional", 0.5}, {"lens", 1}, {"primary", primary_auto_weight}}));
  ASSERT_EQ(diffuse.left_out.size(), 2u);
  EXPECT_NE(diffuse.left_out.at("caustic").find("no smooth or rough mirror"), std::string::npos);
  EXPECT_NE(diffuse.left_out.at("multichain").find("no path has a specular"), std::string::npos);

  scene.specular = scene.caustic_paths_possible = true;
  const MutationChoice all = choose_mutations(scene);
  EXPECT_EQ(all.taken.size(), UsualFamily::count);
  EXPECT_EQ(words(all), (Words{{"bidirectional", 0.5},
                               {"lens", 1},
                               {"caustic", 1},
                               {"multichain", 1},
                               {"primary", primary_auto_weight}}));
  EXPECT_TRUE(all.left_out.empty());
  scene.max_vertices = 3;
  EXPECT_EQ(choose_mutations(scene).left_out.count("multichain"), 1u);
}

TEST(Catalogue, AFamilyOfASceneWeighsWhatIsChosenAndMovesAsUsual) {
  Requirements scene;
  scene.scatters = true;
  scene.max_vertices = 6;
  const Family family = make_family({}, scene);
  const double small = (1 - default_large_step) * primary_auto_weight;
  const std::array<double, 6> expected{0.5, 1,     0,
                                       0,   small, default_large_step * primary_auto_weight};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_DOUBLE_EQ(family.weights()[i], expected[i]);
  EXPECT_EQ(member<Lens>(family).range.angle.largest, PerturbationRange{}.angle.largest);
  EXPECT_EQ(member<Lens>(family).range.position.smallest, PerturbationRange{}.position.smallest);
  // Weights that are said are not chosen anew.
  EXPECT_EQ(make_family({{{"caustic", 3}}}, scene).weights(),
            (std::array<double, 6>{0, 0, 3, 0, 0, 0}));
}

}  // namespace
}  // namespace wander::test
