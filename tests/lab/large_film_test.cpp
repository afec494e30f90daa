// The same run with its film kept as a small one and as a large one: the film is the same but for
// the rounding of float, and error bars tell the same of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/film_statistics.h"
#include "lab/engine.h"
#include "records/film_layers.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

constexpr FilmLayout small{},
    large{.most_small = 4, .by_length = Keep::always, .maps = Keep::always};

// 64 groups make 2048 steps each.
Rendering rendered(const char* method, const FilmLayout& film, NormalizationMethod b,
                   int threads = 2, FilmParts parts = FilmParts::chains) {
  Session session;
  session.budget = SampleBudget{64 * 2048};
  session.threads = threads;
  const Dials dials{.chains = {.film_parts = parts, .normalization = b}, .film = film};
  return render({diffuse_room(), find_method(method), dials}, session);
}

double norm(const std::vector<double>& values) {
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0));
}

class LargeFilms : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, LargeFilms, ::testing::Values("bdpt", "mlt", "pssmlt", "mmlt"));

TEST_P(LargeFilms, AreTheSmallOnesUpToTheRoundingOfFloat) {
  for (const auto b : {NormalizationMethod::bridge, NormalizationMethod::seed_pass}) {
    const Rendering x = rendered(GetParam(), large, b), y = rendered(GetParam(), small, b);
    EXPECT_EQ(x.samples, y.samples);
    ASSERT_EQ(x.film.value.size(), y.film.value.size());
    for (std::size_t j = 0; j < y.film.value.size(); ++j)
      EXPECT_NEAR(x.film.value[j], y.film.value[j], 1e-6 * mean_value(y.film)) << j;
    ASSERT_EQ(x.film.by_length.size(), y.film.by_length.size());
    for (const auto& [vertices, film] : y.film.by_length)
      for (std::size_t j = 0; j < film.size(); ++j)
        EXPECT_NEAR(x.film.by_length.at(vertices)[j], film[j], 1e-6 * mean_value(y.film)) << j;
    // Of 16 parts and of 64: the spread of a ratio of two such estimates is 20 %, of one bin.
    const double errors = norm(x.film.standard_error) / norm(y.film.standard_error);
    EXPECT_GT(errors, 0.75);
    EXPECT_LT(errors, 1.35);
    EXPECT_LE(x.film.degrees_of_freedom, y.film.degrees_of_freedom);
    if (x.normalization) {
      EXPECT_EQ(x.normalization->value, y.normalization->value);
      EXPECT_EQ(x.normalization->standard_error, y.normalization->standard_error);
    }
  }
}

// Pooled of samples and chains: the same, but that the two parts of a bin are taken for independent.
TEST(PooledLargeFilms, AreTheSmallOnesUpToTheRoundingOfFloat) {
  for (const char* method : {"mlt", "pssmlt", "mmlt"}) {
    SCOPED_TRACE(method);
    const auto made = [&](const FilmLayout& film) {
      return rendered(method, film, NormalizationMethod::bridge, 2, FilmParts::pooled);
    };
    const Rendering x = made(large), y = made(small);
    ASSERT_TRUE(x.pooling && y.pooling && x.chains_film && y.chains_film);
    const double mean = mean_value(y.film);
    EXPECT_NEAR(x.pooling->light_of_samples, y.pooling->light_of_samples, 1e-6);
    EXPECT_NEAR(x.normalization->value, mean, 1e-9 * mean);
    for (std::size_t j = 0; j < y.film.value.size(); ++j) {
      EXPECT_NEAR(x.film.value[j], y.film.value[j], 2e-6 * mean) << j;
      EXPECT_NEAR(x.chains_film->value[j], y.chains_film->value[j], 1e-3 * mean) << j;
      EXPECT_NEAR(x.pooling->film_of_samples[j], y.pooling->film_of_samples[j], 2e-6 * mean) << j;
    }
    for (const auto& [vertices, film] : y.film.by_length)
      for (std::size_t j = 0; j < film.size(); ++j)
        EXPECT_NEAR(x.film.by_length.at(vertices)[j], film[j], 2e-6 * mean) << j;
    const double errors = norm(x.film.standard_error) / norm(y.film.standard_error);
    EXPECT_GT(errors, 0.7);
    EXPECT_LT(errors, 1.5);
  }
}

// What of b is of paths of each length is what their films have, of both sides together; and known as well as they.
TEST(PooledLargeFilms, HaveTheLengthsOfTheirFilmsAsSmallOnesDo) {
  for (const char* method : {"mlt", "pssmlt", "mmlt"})
    for (const FilmLayout& layout : {large, small}) {
      SCOPED_TRACE(method);
      const Rendering x =
          rendered(method, layout, NormalizationMethod::bridge, 2, FilmParts::pooled);
      const auto& lengths = x.normalization->by_length;
      ASSERT_EQ(lengths.size(), x.film.by_length.size());
      double sum = 0;
      for (const LengthShare& length : lengths) {
        const std::vector<double>& film = x.film.by_length.at(length.vertices);
        const double mean =
            std::accumulate(film.begin(), film.end(), 0.0) / static_cast<double>(film.size());
        EXPECT_NEAR(length.value, mean, 2e-6 * x.normalization->value) << length.vertices;
        EXPECT_GT(length.standard_error, 0);
        sum += length.value;
      }
      EXPECT_NEAR(sum, x.normalization->value, 1e-9 * sum);
      // Direct light is a third of it, and seen by nearly all samples.
      EXPECT_LT(lengths.front().standard_error, 0.1 * lengths.front().value);
    }
}
TEST(PooledLargeFilms, DoNotDependOnTheThreads) {
  const auto made = [](int threads) {
    return rendered("mlt", large, NormalizationMethod::bridge, threads, FilmParts::pooled);
  };
  const Rendering one = made(1), three = made(3);
  EXPECT_EQ(one.film.value, three.film.value);
  EXPECT_EQ(one.film.standard_error, three.film.standard_error);
  EXPECT_EQ(one.chains_film->value, three.chains_film->value);
}

TEST_P(LargeFilms, DoNotDependOnTheThreads) {
  const Rendering one = rendered(GetParam(), large, NormalizationMethod::bridge, 1);
  const Rendering three = rendered(GetParam(), large, NormalizationMethod::bridge, 3);
  EXPECT_EQ(one.film.value, three.film.value);
  EXPECT_EQ(one.film.standard_error, three.film.standard_error);
  EXPECT_EQ(one.film.by_length, three.film.by_length);
}

// Cells of a raster do not all have as many pixels: spread over them, proposals stay as many.
TEST(LargeFilm, SpreadsWhatIsCountedByCellsOverTheirPixels) {
  description::Scene scene = diffuse_room();
  for (description::Shape& shape : scene.shapes)
    if (shape.sensor) shape.sensor->resolution = {20'011};
  Session session;
  session.budget = SampleBudget{64 * 256};
  const Rendering found =
      render({scene, find_method("mlt"), {.film = {.maps = Keep::always}}}, session);
  int maps = 0;
  for (const FilmLayer& layer : layers_of(found))
    for (const MutationRecord& mutation : found.mutations) {
      if (layer.name != "proposed." + mutation.name) continue;
      ++maps;
      double all = 0;
      for (std::size_t j = 0; j < found.film.value.size(); ++j) all += layer.number(j);
      EXPECT_NEAR(all, static_cast<double>(mutation.proposed), 1e-6);
      EXPECT_LT(mutation.proposed_per_bin.size(), found.film.value.size());
    }
  EXPECT_GT(maps, 1);
}

TEST(LargeFilm, HasMapsOnARasterAndOnlyIfAskedFor) {
  const Rendering asked = rendered("mlt", large, NormalizationMethod::bridge);
  const Rendering plain = rendered("mlt", {.most_small = 4}, NormalizationMethod::bridge);
  ASSERT_EQ(asked.mutations.size(), plain.mutations.size());
  for (std::size_t m = 0; m < plain.mutations.size(); ++m) {
    EXPECT_TRUE(plain.mutations[m].proposed_per_bin.empty());
    const std::vector<double>& map = asked.mutations[m].proposed_per_bin;
    EXPECT_LE(map.size(), 4u);
    EXPECT_EQ(std::accumulate(map.begin(), map.end(), 0.0),
              static_cast<double>(plain.mutations[m].proposed));
  }
  EXPECT_TRUE(plain.film.by_length.empty());
}

}  // namespace
}  // namespace wander::test
