// Films in single precision, of every method, are those of double precision or of exact values
// within their error bars; so are films of large steps that are rare or frequent, and of kernels
// that reach far or hardly move.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include <map>

#include "lab/engine.h"
#include "lab/scene_source.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/test_scenes.h"

namespace wander::test::precision_films_test {
namespace {

constexpr int bins = 8;

description::Scene gallery(const std::string& name) {
  description::Scene scene = open_scene("gallery:" + name).scene;
  for (auto& shape : scene.shapes)
    if (shape.sensor) shape.sensor->resolution = {bins};
  return scene;
}

Session session_of(std::uint64_t samples, std::uint64_t seed) {
  Session session;
  session.budget = SampleBudget{samples};
  session.seed = seed;
  session.threads = 2;
  return session;
}

FilmEstimate dimmed(FilmEstimate film) {
  for (double& value : film.value) value *= 0.5;
  return film;
}

// By bidirectional path tracing in double precision; of each scene once.
const FilmEstimate& reference_of(const description::Scene& scene) {
  static std::map<std::string, FilmEstimate> known;
  const auto found = known.find(scene.name);
  if (found != known.end()) return found->second;
  const Rendering rendering = render({scene, find_method("bdpt")}, session_of(60'000, 2));
  EXPECT_EQ(rendering.precision, "double");
  return known.emplace(scene.name, rendering.film).first->second;
}

class SingleFilms : public ::testing::TestWithParam<const char*> {
 protected:
  static FilmEstimate film_of(const description::Scene& scene, std::string_view method,
                              std::uint64_t samples = 25'000) {
    const Rendering rendering = render(
        {scene, find_method(method), {.precision = Precision::of_float}}, session_of(samples, 1));
    EXPECT_EQ(rendering.precision, "float");
    return rendering.film;
  }
};
INSTANTIATE_TEST_SUITE_P(Methods, SingleFilms,
                         ::testing::Values("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt", "pt-naive",
                                           "lt-naive"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(SingleFilms, OfAFurnaceAreExact) {
  // 2 L with L = 1 + ρ + ρ² + … + ρ⁶, ρ = 1/2.
  const FilmEstimate exact{.shape = {bins},
                           .value = std::vector<double>(bins, 3.96875),
                           .standard_error = std::vector<double>(bins, 0),
                           .reliable = std::vector<bool>(bins, true),
                           .degrees_of_freedom = 1};
  const FilmEstimate film = film_of(gallery("furnace"), GetParam());
  const Decision decision = films_agree(film, exact, usual_false_alarm);
  EXPECT_TRUE(passes(decision));
  EXPECT_GE(decision.comparisons, 1u);
  EXPECT_TRUE(rejects(films_agree(film, dimmed(exact), usual_false_alarm)));
}

TEST_P(SingleFilms, AreThoseOfDoublePrecision) {
  const std::string_view method = GetParam();
  for (const description::Scene& scene :
       {gallery("article-2"), gallery("lens"), mirror_and_glass(), rough_room()}) {
    const Decision decision =
        films_agree(film_of(scene, method), reference_of(scene), usual_false_alarm);
    if (decision.comparisons == 0) continue;  // light is too rare for this method
    EXPECT_TRUE(passes(decision)) << method << ", " << scene.name;
  }
  const description::Scene room = gallery("article-2");
  const Decision twin =
      films_agree(film_of(room, "bdpt"), dimmed(reference_of(room)), usual_false_alarm);
  EXPECT_TRUE(rejects(twin));
}

// ---- dials

struct Turned {
  const char* name;
  Dials dials;
};
class TurnedFilms : public ::testing::TestWithParam<Turned> {};
INSTANTIATE_TEST_SUITE_P(Dials, TurnedFilms,
                         ::testing::Values(Turned{"LargeStepsAreRare", {.large_step = 0.01}},
                                           Turned{"LargeStepsAreFrequent", {.large_step = 0.99}},
                                           Turned{"MovesAreShort", {.kernel = 0.01}},
                                           Turned{"MovesAreLong", {.kernel = 10}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(TurnedFilms, AreTheSameWithinTheirErrors) {
  const description::Scene scene = mirror_and_glass();
  for (const char* method : {"mlt", "pssmlt", "mmlt"}) {
    const FilmEstimate film =
        render({scene, find_method(method), GetParam().dials}, session_of(40'000, 1)).film;
    const Decision decision = films_agree(film, reference_of(scene), usual_false_alarm);
    if (decision.comparisons == 0) continue;  // short moves leave few bins reliable
    EXPECT_TRUE(passes(decision)) << method;
  }
}

}  // namespace
}  // namespace wander::test::precision_films_test
