// What is looked up once for a sample is what every path of it says by itself.
#include "core/bins_of_sample.h"

#include <gtest/gtest.h>

#include "core/path_sampler.h"
#include "tests/support/core_scenes.h"
#include "tests/support/space_box.h"

namespace wander::test::bins_of_sample_test {
namespace {

template <World W>
void expect_bins(const Scene<W>& scene) {
  const Transport<W> space(scene, Roulette::by_albedo);
  PathSampler<Transport<W>> sampler(space, all_techniques, Heuristic::balance);
  BinsOfSample<Transport<W>> bins(space);
  Rng random(3, Purpose::test, 0);
  int paths = 0, samples_with_several = 0;
  for (int i = 0; i < 1000; ++i) {
    random.start(static_cast<std::uint64_t>(i));
    bins.begin();
    int first = -1;
    bool differ = false;
    sampler.sample(random, [&](const JoinedPath<W>& x, int s, double) {
      const int bin = space.bin(x.ends());
      EXPECT_EQ(bins(x, s), bin) << "sample " << i << ", s = " << s << ", " << x.size()
                                 << " vertices";
      if (first < 0) first = bin;
      differ = differ || bin != first;
      ++paths;
    });
    if (differ) ++samples_with_several;
  }
  EXPECT_GT(paths, 1000);
  EXPECT_GT(samples_with_several, 50);  // else one bin for a whole sample would do
}

TEST(BinsOfSample, AreThoseOfItsPathsOneByOne) {
  expect_bins(*open_room(6).build());
  expect_bins(Scene<Spaceland>(space_box()));
  for (const double lens : {0.0, 0.05}) expect_bins(Scene<Spaceland>(space_box_by_camera(lens)));
}

}  // namespace
}  // namespace wander::test::bins_of_sample_test
