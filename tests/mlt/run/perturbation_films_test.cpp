// Films by chains of one perturbation and the primary steps, which make the chain ergodic, against
// films that are known: diffuse walls solved by radiosity, a mirror and a line of glass in closed
// form, and independent samples where specular chains follow each other.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/exact/radiosity.h"
#include "lab/estimate.h"
#include "lab/render.h"
#include "mutations/catalogue.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/reference_values.h"
#include "tests/support/test_scenes.h"

namespace wander::test::perturbation_films_test {

using namespace exact;
namespace {

Session session_of(std::uint64_t samples) {
  Session session;
  session.budget = SampleBudget{samples};
  return session;
}

FilmEstimate by_chains(const Scene<Flatland>& scene, const MutationWeights& weights) {
  const Transport<Flatland> space(scene, Roulette::off);
  const Family family = make_family({weights}, scene.max_vertices());
  const Session session = session_of(200'000);
  return ChainRenderer(space, family, session, ChainSettings{}).render("mlt").film;
}
FilmEstimate by_samples(const Scene<Flatland>& scene) {
  const auto bdpt = std::ranges::find(estimators(), std::string_view("bdpt"), &Estimator::name);
  return estimate(scene, *bdpt, session_of(250'000)).film;
}

// A film without error.
FilmEstimate known(const std::vector<double>& values, double factor = 1) {
  FilmEstimate film;
  for (const double value : values) film.value.push_back(factor * value);
  film.standard_error.assign(values.size(), 0);
  film.reliable.assign(values.size(), true);
  film.degrees_of_freedom = 1e9;
  return film;
}

// Each perturbation with primary steps, one step in four.
MutationWeights mostly(const char* word) { return {{word, 3}, {"primary", 1}}; }

void expect_film(const Scene<Flatland>& scene, const std::vector<double>& exact) {
  for (const char* word : {"lens", "caustic"}) {
    const FilmEstimate film = by_chains(scene, mostly(word));
    const Decision agree = films_agree(film, known(exact), usual_false_alarm);
    EXPECT_TRUE(passes(agree)) << word;
    EXPECT_GE(agree.comparisons, std::size_t{4}) << word;
    EXPECT_TRUE(rejects(films_agree(film, known(exact, 1.3), usual_false_alarm))) << word;
  }
}

TEST(PerturbedFilms, OfADiffuseRoomAreThoseOfRadiosity) {
  const description::Scene room = diffuse_room();
  expect_film(*build(room), solve_radiosity(radiosity_scene(room)).film().mean_irradiance);
}

TEST(PerturbedFilms, UnderAMirrorAreExact) {
  namespace scene = reference::mirror;
  SceneMaker maker(4);
  maker.line(scene::reflector, {maker.mirror(scene::reflectance)});
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::sensor, {.bins = 8});
  std::vector<double> exact(scene::film.rbegin(), scene::film.rend());  // it runs against x
  expect_film(*maker.build(), exact);
}

TEST(PerturbedFilms, InsideGlassAreExact) {
  namespace scene = reference::refraction;
  SceneMaker maker(6);
  maker.line(scene::interface, {maker.glass(1.5)});
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::sensor, {.bins = 4});
  expect_film(*maker.build(), {scene::film.begin(), scene::film.end()});
}

TEST(PerturbedFilms, BetweenMirrorsAreThoseOfIndependentSamples) {
  const FlatScene scene = build(mirror_corridor());
  const FilmEstimate expected = by_samples(*scene);
  for (const char* word : {"lens", "caustic", "multichain"}) {
    const Decision agree =
        films_agree(by_chains(*scene, mostly(word)), expected, usual_false_alarm);
    EXPECT_TRUE(passes(agree)) << word;
    EXPECT_GE(agree.comparisons, std::size_t{4}) << word;
  }
}

}  // namespace
}  // namespace wander::test::perturbation_films_test
