// Films in colour: every method shows the same, each channel is the film of its own light, and what
// a chain deposits has the luminance that the constant b is of.  False-alarm rate 1e-9 per decision.
// What is seen here is large, from either side: a channel taken for another, or for grey.  A small
// error of a path's colour is for the exact test, tests/core/colour_test.cpp.
#include <gtest/gtest.h>

#include "lab/engine.h"
#include "tests/support/coloured_box.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"

namespace wander::test {
namespace {

Rendering rendered(const description::Scene& scene, const char* method, std::uint64_t samples,
                   std::uint64_t seed, FilmParts parts = FilmParts::pooled) {
  Session session;
  session.budget = SampleBudget{samples};
  session.threads = 2;
  session.seed = seed;
  Dials dials;
  dials.chains.film_parts = parts;
  return render(Job(scene, find_method(method), dials), session);
}

// One channel of a film.
FilmEstimate film_channel(const FilmEstimate& film, std::size_t channel) {
  FilmEstimate one{.shape = {film.shape[0], film.shape[1]},
                   .degrees_of_freedom = film.degrees_of_freedom};
  for (std::size_t i = channel; i < film.value.size(); i += 3) {
    one.value.push_back(film.value[i]);
    one.standard_error.push_back(film.standard_error[i]);
    one.reliable.push_back(film.reliable[i]);
  }
  return one;
}

class ColouredFilms : public ::testing::TestWithParam<const char*> {};

TEST_P(ColouredFilms, AreInEachChannelTheFilmsOfItsLight) {
  const Rendering film = rendered(coloured_box_without_caustics(), GetParam(), 100'000, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    const Rendering one =
        rendered(channel_of(coloured_box_without_caustics(), k), "bdpt", 50'000, 2 + k);
    EXPECT_TRUE(passes(films_agree(film_channel(film.film, k), one.film, 1e-9))) << k;
    EXPECT_TRUE(rejects(films_agree(film_channel(film.film, (k + 1) % 3), one.film, 1e-9))) << k;
  }
}

class ColouredChains : public ::testing::TestWithParam<const char*> {};

// Exact but for deposits in float.
TEST_P(ColouredChains, HaveTheNormalizationAsTheMeanOfTheirLuminance) {
  for (const FilmParts parts : {FilmParts::chains, FilmParts::pooled}) {
    const Rendering run = rendered(coloured_box_without_caustics(), GetParam(), 20'000, 1, parts);
    ASSERT_TRUE(run.normalization);
    double mean = 0, of_channels_alike = 0;
    for (std::size_t i = 0; i < run.film.value.size(); ++i)
      mean += luminance_weight(3, i) * run.film.value[i];
    mean /= static_cast<double>(run.film.value.size()) / 3;
    for (const double value : run.film.value) of_channels_alike += value;
    of_channels_alike /= static_cast<double>(run.film.value.size());
    EXPECT_NEAR(mean, run.normalization->value, 1e-6 * mean);
    EXPECT_GT(std::abs(of_channels_alike / mean - 1), 1e-3);  // the wrong twin
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, ColouredFilms,
                         ::testing::Values("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt"),
                         [](const auto& info) { return std::string(info.param); });
INSTANTIATE_TEST_SUITE_P(Methods, ColouredChains, ::testing::Values("mlt", "pssmlt", "mmlt"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace wander::test
