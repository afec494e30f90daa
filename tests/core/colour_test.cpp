// Colour: paths know the light of each channel, and the film gets it.
#include <gtest/gtest.h>

#include "core/path_sampler.h"
#include "scenes/format/build_scene.h"
#include "tests/support/coloured_box.h"

namespace wander::test {
namespace {

struct Found {
  int vertices, technique, bin;
  double value;  // luminance
  std::array<double, 3> light;
};

// The contributions of the same random numbers.  Without roulette, the walks depend on no colour.
template <World W>
std::vector<Found> found_in(const description::Scene& description) {
  const auto scene = build_scene<W>(description);
  const Transport<W> space(*scene, Roulette::off);
  PathSampler<Transport<W>> sampler(space, all_techniques, Heuristic::balance);
  std::vector<Found> all;
  Rng rng(1, Purpose::estimate, 0);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    rng.start(i);
    sampler.sample(rng, [&](const Path<W>& x, int s, double value) {
      Found found{x.size(), s, space.bin(x), value, {value, value, value}};
      if constexpr (W::channels == 3)
        for (std::size_t k = 0; k < 3; ++k) found.light[k] *= colour(x)[static_cast<int>(k)];
      all.push_back(found);
    });
  }
  return all;
}

// Exact: to rounding.
TEST(Colour, OfAPathIsItsLightInEachChannel) {
  const std::vector<Found> coloured = found_in<SpacelandColour>(coloured_box());
  ASSERT_GT(coloured.size(), 1000U);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Found> one = found_in<Spaceland>(channel_of(coloured_box(), k));
    ASSERT_EQ(one.size(), coloured.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(one[i].bin, coloured[i].bin);
      ASSERT_EQ(one[i].technique, coloured[i].technique);
      EXPECT_NEAR(coloured[i].light[k], one[i].light[k], 1e-13 * one[i].light[k]);
    }
  }
}

// The wrong twin: a contribution that is the product of luminances differs from the luminance of the
// product by more than 1e-3 on more than a tenth of all paths.
TEST(Colour, IsNotTheProductOfLuminances) {
  const std::vector<Found> coloured = found_in<SpacelandColour>(coloured_box());
  const std::vector<Found> grey = found_in<Spaceland>(coloured_box());
  ASSERT_EQ(grey.size(), coloured.size());
  int different = 0;
  for (std::size_t i = 0; i < grey.size(); ++i)
    if (std::abs(luminance(coloured[i].light) - grey[i].light[0]) > 1e-3 * grey[i].light[0])
      ++different;
  EXPECT_GT(different, static_cast<int>(grey.size()) / 10);
}

TEST(Colour, HasLuminanceOneBesideItsLight) {
  for (const Found& found : found_in<SpacelandColour>(coloured_box()))
    EXPECT_NEAR(luminance(found.light), found.value, 1e-13 * found.value);
  EXPECT_DOUBLE_EQ(luminance(Tint<3>::of({0.3, 0.2, 0.9})), 1);
  EXPECT_EQ(Tint<3>::of({0, 0, 0}).colour, (std::array<double, 3>{1, 1, 1}));
  EXPECT_TRUE(std::is_empty_v<Tint<1>>);
  EXPECT_LT(sizeof(Vertex<Spaceland>), sizeof(Vertex<SpacelandColour>));
}

}  // namespace
}  // namespace wander::test
