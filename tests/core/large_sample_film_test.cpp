// A large film of samples, held against a small one that gets the same samples.
#include "core/large_sample_film.h"

#include <gtest/gtest.h>

#include <array>

#include "core/rng.h"

namespace wander::test {
namespace {

constexpr int bins = 40, max_vertices = 6;
constexpr FilmLayout large{.most_small = 8, .by_length = Keep::always};

// Paths of a sample often meet in a bin.
Contributions sample_of(Rng& random) {
  Contributions sample;
  const auto below = [&](int n) { return static_cast<int>(n * random.uniform()); };
  for (int paths = below(5); paths > 0; --paths)
    sample.push_back(
        {2 + below(max_vertices - 1), below(3), below(3) * below(13), random.uniform()});
  return sample;
}

class LargeSampleFilms : public ::testing::Test {
 protected:
  // Units of 7 samples.
  void fill(int units) {
    SampleList part(bins, max_vertices, large);
    Rng random(1, Purpose::test, 91);
    for (int unit = 0; unit < units; ++unit) {
      part.clear();
      for (int i = 0; i < 7; ++i) {
        random.start(static_cast<std::uint64_t>(7 * unit + i));
        const Contributions sample = sample_of(random);
        part.add(sample);
        small_.add(sample);
      }
      large_.merge(part);
    }
  }

  SampleFilm small_{bins, max_vertices};
  LargeSampleFilm large_{bins, max_vertices, large};
};

TEST_F(LargeSampleFilms, SayWhatASmallFilmOfTheSameSamplesSays) {
  fill(300);
  constexpr std::array shape{bins};
  const FilmEstimate a = large_.estimate(shape), b = small_.estimate(shape);
  EXPECT_EQ(large_.samples(), small_.samples());
  EXPECT_EQ(a.reliable, b.reliable);
  EXPECT_EQ(a.degrees_of_freedom, b.degrees_of_freedom);
  ASSERT_EQ(a.by_length.size(), b.by_length.size());
  for (std::size_t i = 0; i < bins; ++i) {
    EXPECT_NEAR(a.value[i], b.value[i], 1e-12);
    EXPECT_NEAR(a.standard_error[i], b.standard_error[i], 1e-12);
    for (const auto& [vertices, film] : b.by_length)
      EXPECT_NEAR(a.by_length.at(vertices)[i], film[i], 1e-12);
  }
}

TEST_F(LargeSampleFilms, HaveNoPartsByLengthThatWereNotAskedFor) {
  LargeSampleFilm plain(bins, max_vertices, {.most_small = 8});
  SampleList part(bins, max_vertices, {.most_small = 8});
  part.add({{2, 0, 1, 1.0}});
  plain.merge(part);
  EXPECT_TRUE(plain.estimate(std::array{bins}).by_length.empty());
}

}  // namespace
}  // namespace wander::test
