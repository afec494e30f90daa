// The importance map that a test image makes.  How it falls with the light of blocks is tested with what else is made
// of a test image (bin_worth_test.cpp).
#include "mlt/run/test_image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/core_scenes.h"
#include "tests/support/space_box.h"

namespace wander::test::test_image_test {
namespace {

bool goes_on() { return false; }

TEST(TestImages, AreOfImages) {
  const auto curve = open_room(4).build();
  const Transport<Flatland> flat(*curve, Roulette::off);
  EXPECT_FALSE(importance_of_test_image(flat, goes_on).has_value());
  const Scene<Spaceland> box(space_box_by_camera(0));
  const Transport<Spaceland> space(box, Roulette::off);
  EXPECT_FALSE(importance_of_test_image(space, [] { return true; }).has_value()) << "interrupted";
  EXPECT_TRUE(importance_of_test_image(space, goes_on).has_value());
}

// Runs are merged as if they were one, so they have to measure alike.
TEST(TestImages, AreTheSameWheneverTheyAreMade) {
  const Scene<Spaceland> box(space_box_by_camera(0));
  const Transport<Spaceland> space(box, Roulette::off);
  const auto once = importance_of_test_image(space, goes_on),
             again = importance_of_test_image(space, goes_on);
  const int bins = box.resolution()[0] * box.resolution()[1];
  for (int j = 0; j < bins; ++j) EXPECT_EQ((*once)(j), (*again)(j));
}

// Of what is measured by it every block that has light has about as much, and all together as much as before.
TEST(TestImages, MakeTheMeasureEven) {
  const Scene<Spaceland> box(space_box_by_camera(0));
  const Transport<Spaceland> space(box, Roulette::off);
  const ImportanceMap importance = importance_of_test_image(space, goes_on).value();
  const auto resolution = box.resolution();
  const int bins = resolution[0] * resolution[1];
  std::vector<double> light(static_cast<std::size_t>(bins));
  PathSampler<Transport<Spaceland>> sampler(space.with(Roulette::by_albedo), all_techniques,
                                            Heuristic::balance);
  Rng random(3, Purpose::test, 0);
  for (std::uint64_t i = 0; i < 40'000; ++i) {
    random.start(i);
    sampler.sample(random, [&](const auto& x, int, double weight) {
      light[static_cast<std::size_t>(space.bin(x.ends()))] += weight;
    });
  }
  // Coefficients of variation over the bins, of the light and of what is measured.
  double all = 0, measured = 0, squares = 0, squares_measured = 0;
  for (int j = 0; j < bins; ++j) {
    const double x = light[static_cast<std::size_t>(j)], y = importance(j) * x;
    all += x;
    squares += x * x;
    measured += y;
    squares_measured += y * y;
  }
  const double spread = bins * squares / (all * all) - 1,
               spread_measured = bins * squares_measured / (measured * measured) - 1;
  EXPECT_LT(spread_measured, 0.5 * spread);
  EXPECT_NEAR(measured / all, 1, 0.1) << "E_π[v]";
}

}  // namespace
}  // namespace wander::test::test_image_test
