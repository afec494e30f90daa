// A space with an importance map finds the paths of the space without, and measures v times as much.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/importance_map.h"
#include "core/path_sampler.h"
#include "tests/support/core_scenes.h"
#include "tests/support/space_box.h"

namespace wander::test::importance_map_test {
namespace {

TEST(ImportanceMap, IsConstantOnBlocks) {
  const ImportanceMap importance(Raster(std::vector{64, 64}, 1024), std::vector<double>(1024, 3));
  EXPECT_EQ(importance(64 * 64 - 1).v, 3);
  const ImportanceMap of_curve(Raster(3), {1, 2, 4});
  for (const int bin : {0, 1, 2}) EXPECT_EQ(of_curve(bin).v, 1 << bin);
}

struct Found {
  int bin;
  double weight;
};

template <World W>
std::vector<Found> samples_of(const Transport<W>& space, int count) {
  PathSampler<Transport<W>> sampler(space.with(Roulette::by_albedo), all_techniques,
                                    Heuristic::balance);
  Rng random(3, Purpose::test, 0);
  std::vector<Found> found;
  for (int i = 0; i < count; ++i) {
    random.start(static_cast<std::uint64_t>(i));
    sampler.sample(random, [&](const auto& x, int, double weight) {
      found.push_back({space.bin(x.ends()), weight});
    });
  }
  return found;
}

template <World W>
void expect_measured(const Scene<W>& scene) {
  const auto resolution = scene.resolution();
  int bins = 1;
  for (const int extent : resolution) bins *= extent;
  std::vector<double> factors;
  for (int j = 0; j < bins; ++j) factors.push_back(j % 2 == 0 ? 0.5 : 1.0 + 7.0 * j / bins);
  const ImportanceMap importance(
      Raster(std::vector<int>(resolution.begin(), resolution.end()), factors.size()), factors);
  const Transport<W> plain(scene, Roulette::off), measuring = plain.measuring(importance);
  const std::vector<Found> light = samples_of(plain, 2000), measured = samples_of(measuring, 2000);
  ASSERT_EQ(light.size(), measured.size());
  ASSERT_GT(light.size(), 500u);
  for (std::size_t k = 0; k < light.size(); ++k) {
    const int bin = light[k].bin;
    ASSERT_EQ(measured[k].bin, bin);
    EXPECT_NEAR(measured[k].weight / light[k].weight, factors[static_cast<std::size_t>(bin)],
                1e-12 * factors[static_cast<std::size_t>(bin)]);
    EXPECT_NEAR(light_of_measure(measuring, bin) * importance(bin).v, 1, 1e-15);
    EXPECT_EQ(light_of_measure(plain, bin), 1);
  }
}

TEST(ImportanceMap, IsAFactorOfWhatASensorMeasures) {
  const auto scene = open_room(6).build();
  expect_measured(*scene);
}
TEST(ImportanceMap, IsAFactorOfWhatACameraMeasures) {
  expect_measured(Scene<Spaceland>(space_box()));
  for (const double lens : {0.0, 0.05})
    expect_measured(Scene<Spaceland>(space_box_by_camera(lens)));
}

}  // namespace
}  // namespace wander::test::importance_map_test
