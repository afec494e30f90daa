// The importance map that a test image makes.  How it falls with light that is well known is tested with what else is
// made of a test image (bin_worth_test.cpp).
#include "mlt/run/test_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

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

// 1/v over its value on the first bin, where so many paths of light one were found on each.
std::vector<double> believed(std::span<const int> resolution, const std::vector<int>& paths) {
  TestImage image(resolution);
  for (std::size_t j = 0; j < paths.size(); ++j)
    for (int k = 0; k < paths[j]; ++k) image.add(static_cast<int>(j), 1);
  // Of so many samples that none is bright beside what they find.
  const ImportanceMap importance = image.importance(1).value();
  std::vector<double> values;
  for (std::size_t j = 0; j < paths.size(); ++j)
    values.push_back(importance(0).v / importance(static_cast<int>(j)).v);
  return values;
}
void expect_near(const std::vector<double>& seen, const std::vector<double>& light) {
  double mean = 0;
  for (const double x : light) mean += x / static_cast<double>(light.size());
  for (std::size_t j = 0; j < light.size(); ++j)
    EXPECT_NEAR(seen[j], (light[j] + 0.2 * mean) / (light[0] + 0.2 * mean), 2e-3 * seen[j]) << j;
}

// Of four pixels the parent is the whole image; (S + 8)/(1 + 8/8).
TEST(TestImages, ExpectOfAPixelWhatAPoissonNumberOfPathsTells) {
  expect_near(believed(std::array{2, 2}, {24, 8, 0, 0}), {16, 8, 4, 4});
  expect_near(believed(std::array{2, 2}, {2400, 800, 0, 0}),
              {2408 / 1.01, 808 / 1.01, 8 / 1.01, 8 / 1.01});
}

// Between the image and its pixels are blocks of 2 × 2: a dark pixel beside bright ones is brighter than a dark one
// that is far from them.
TEST(TestImages, AskTheNeighbours) {
  std::vector<int> paths(16);
  paths[0] = 64;  // alone in a block
  // 16 paths for each block, of which the first has (64 + 8)/(1 + 8/16) = 48, and the others 8/1.5; of the pixels of the
  // first, which has 12 for each, (64 + 8)/(1 + 8/12) and 8/(5/3), of others, of 4/3, 8/(1 + 6).
  std::vector<double> light(16, 8. / 7);
  light[0] = 72 / (5. / 3);
  light[1] = light[4] = light[5] = 8 / (5. / 3);
  expect_near(believed(std::array{4, 4}, paths), light);
}

// Cells at the edge have fewer pixels.
TEST(TestImages, AreEvenWhereTheImageIs) {
  for (const double value : believed(std::array{201, 203}, std::vector<int>(201 * 203, 2)))
    ASSERT_NEAR(value, 1, 1e-9);
}

// How many times as long chains take for the same mean of (δI/I)² as if all pixels were visited alike: where
// v I is even it is one.  On average a pixel has half of a path.  With eight seeds it is 1.59 to 1.68; told by sixteen
// blocks it would be 1.9 to 2.0, by pixels alone 4.7 to 5.2, and without a map it is 5.5.  So a tenth more shows.
TEST(TestImages, MakeTheMeasureEvenWherePathsAreFew) {
  constexpr int edge = 64;
  std::vector<double> light(edge * edge);
  for (int j = 0; j < edge * edge; ++j) {
    const bool is_bright = j % edge > 20 + (j / edge) / 3;  // an edge that goes through blocks
    light[static_cast<std::size_t>(j)] = is_bright ? 1 : 0.05;
  }
  TestImage image(std::array{edge, edge});
  Rng random(1, Purpose::test, 0);
  random.start(0);
  constexpr int paths = edge * edge / 2;
  for (int i = 0; i < paths;) {
    const auto j = static_cast<std::size_t>(random.uniform() * edge * edge);
    const double u = random.uniform();
    if (u >= light[j]) continue;
    image.add(static_cast<int>(j), 1);
    ++i;
  }
  const ImportanceMap importance = image.importance(paths).value();
  double measure = 0, work = 0;
  for (int j = 0; j < edge * edge; ++j) {
    const double of_bin = importance(j).v * light[static_cast<std::size_t>(j)];
    measure += of_bin / (edge * edge);
    work += 1 / of_bin / (edge * edge);
  }
  EXPECT_LT(measure * work, 1.7);
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
    const double x = light[static_cast<std::size_t>(j)], y = importance(j).v * x;
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
