// Chains and independent samples estimate the same film, whatever the mutations.
//
// False alarms: 1e-9 per comparison of two films.  The error bars of the chains come from 64
// independent groups, so that this holds for chains of any length, even where they mix badly.
#include <gtest/gtest.h>

#include "lab/estimate.h"
#include "lab/render.h"
#include "mutations/catalogue.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

Session session_of(std::uint64_t samples) {
  Session session;
  session.budget = SampleBudget{samples};
  return session;
}

template <class Kernel>
FilmEstimate by_chains(const Scene<Flatland>& scene, const Kernel& kernel) {
  const Flat space(scene, Roulette::off);
  const Session session = session_of(400'000);
  return ChainRenderer(space, kernel, session, ChainSettings{}).render("mlt").film;
}
FilmEstimate by_samples(const Scene<Flatland>& scene) {
  for (const Estimator& estimator : estimators())
    if (std::string_view(estimator.name) == "bdpt")
      return estimate(scene, estimator, session_of(300'000)).film;
  throw std::logic_error("no bdpt");
}

class Agreement : public ::testing::TestWithParam<int> {
 protected:
  FlatScene scene_ = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
};
INSTANTIATE_TEST_SUITE_P(Rooms, Agreement,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST_P(Agreement, ChainsOfAnyMutationsEstimateTheFilmOfIndependentSamples) {
  const FilmEstimate expected = by_samples(*scene_);
  const int longest = scene_->max_vertices();
  for (const MutationWeights& weights : {MutationWeights{}, MutationWeights{{"bidirectional", 1}},
                                         MutationWeights{{"primary", 1}}}) {
    const Decision agree = films_agree(by_chains(*scene_, make_family({weights}, longest)),
                                       expected, usual_false_alarm);
    EXPECT_TRUE(passes(agree));
    EXPECT_GE(agree.comparisons, std::size_t{4});
  }
}

// A film is a blunt instrument, which flaws pass that invariance shows at thirty standard errors:
// the control is a film of brighter light.
TEST(Disagreement, OfFilmsOfDifferentScenesIsCaught) {
  const FlatScene scene = build(diffuse_room()), brighter = build(brightened(diffuse_room(), 1.2));
  const Family family = make_family({}, scene->max_vertices());
  EXPECT_TRUE(
      rejects(films_agree(by_chains(*scene, family), by_samples(*brighter), usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test
