// The border between samples and chains once chains were asked: what was seen is left to samples, and the border may have an end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mlt/run/partition.h"
#include "tests/support/partition_pilots.h"

namespace wander::test::cautious_pooling_test {
namespace {

constexpr std::size_t bins = bins_of_pilot;

// The light that is left to chains, but for the largest path, over all.
double of_chains(const Pilot& pilot, double c) {
  const RatioHistogram found = pilot.found.without_largest();
  double all = 0, hard = 0;
  for (int i = found.first(); i < found.end(); ++i) {
    all += found[i].sum;
    if (found[i].count > 0)
      hard += found[i].sum * Partition{c}.of_chains(found[i].sum / found[i].count);
  }
  return hard / all;
}

// What is chosen of a pilot whose chains were asked, by going through all there is.
struct Cautious {
  bool is_of_samples;  // they promise no more than two and a half times as much
  Pooling pooling;
};
Cautious by_cautious_rule(const Pilot& pilot) {
  std::vector<Pooling> all = all_choices(pilot);
  const auto of = [&](const Pooling& one) { return work(pilot, one); };
  const auto border = [](const Pooling& one) { return one.partition.c; };
  const Pooling best = std::ranges::min(all, {}, of);
  double most = INFINITY;
  for (const double c : borders_around(pilot.b()))
    if (c >= 1024 * pilot.b() && of_chains(pilot, c) <= 1. / 1024) most = std::min(most, c);
  most = std::max(most, best.partition.c);
  std::erase_if(all, [&](const Pooling& one) {
    return one.partition.c < 1024 * pilot.b() || one.partition.c > most || of(one) > 2.5 * of(best);
  });
  if (all.empty()) return {false, best_pooling(pilot, bins)};
  const double c = border(std::ranges::max(all, {}, border));
  std::erase_if(all, [&](const Pooling& one) { return one.partition.c != c; });
  return {true, std::ranges::min(all, {}, of)};
}

// Once chains are asked what was seen is left to samples, unless chains promise more than two and a half times as much.
TEST(Pooling, LeavesToChainsWhatTheyDoMuchBetter) {
  int by_samples = 0, beyond = 0, by_chains = 0;
  for (int count = 5; count <= 1280; count *= 2) {
    const Pilot pilot = pilot_of({{1, 5000}, {400, count}});
    const Pooling chosen = cautious_pooling(pilot, bins), best = best_pooling(pilot, bins);
    const auto [is_of_samples, expected] = by_cautious_rule(pilot);
    EXPECT_EQ(chosen.partition.c, expected.partition.c) << count;
    EXPECT_EQ(chosen.samples_per_step, expected.samples_per_step) << count;
    if (!is_of_samples) ++by_chains;
    if (is_of_samples && chosen.partition.c > best.partition.c) ++by_samples;
    if (is_of_samples && chosen.partition.c > 1024 * pilot.b()) ++beyond;
  }
  EXPECT_GE(by_samples, 1);
  EXPECT_GE(beyond, 1);
  EXPECT_GE(by_chains, 1);
}

// The longer chains are caught without an end, the rather the border has one; but a quarter less work it must take.
TEST(Pooling, HasAnEndWhereThatTakesAQuarterLessWork) {
  int with_end = 0, nearly = 0;
  for (double steps = 1; steps <= 4096; steps *= 1.25) {
    Pilot pilot = pilot_of({{1, 5000}, {40, 200}, {400, 100}});
    for (const double c : borders_around(pilot.b()))
      pilot.borders.push_back({.c = c, .steps_per_draw = 4096, .steps_per_draw_of_total = 4096});
    const Pooling without = cautious_pooling(pilot, bins);
    pilot.borders.push_back({.c = pilot.b() / 4,
                             .end = 512 * pilot.b(),
                             .steps_per_draw = steps,
                             .steps_per_draw_of_total = steps});
    std::vector<Pooling> all;
    for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2)
      all.push_back({{pilot.b() / 4, 512 * pilot.b()}, rho});
    const auto of = [&](const Pooling& one) { return work(pilot, one); };
    const Pooling best = std::ranges::min(all, {}, of);
    const bool expected = 1.25 * of(best) <= of(without);
    const Pooling chosen = cautious_pooling(pilot, bins);
    EXPECT_EQ(chosen.partition.has_end(), expected) << steps;
    EXPECT_EQ(chosen.samples_per_step, (expected ? best : without).samples_per_step) << steps;
    if (expected) ++with_end;
    if (!expected && of(best) < of(without)) ++nearly;
  }
  EXPECT_GE(with_end, 1);
  EXPECT_GE(nearly, 1) << "no case shows the quarter";
}

// Without an end chains may be caught, and keep only a part of what they promise: two and a half times as much they must.
TEST(Pooling, LeavesMuchToChainsWithoutAnEndWhereThatPromisesAMultiple) {
  int with_end = 0, nearly = 0, without_end = 0;
  for (double steps = 1; steps <= 4096; steps *= 1.25) {
    Pilot pilot = pilot_of({{1, 5000}, {400, 80}});
    for (const double c : borders_around(pilot.b()))
      pilot.borders.push_back({.c = c, .steps_per_draw = 4, .steps_per_draw_of_total = 4});
    const Pooling without = cautious_pooling(pilot, bins);
    ASSERT_LT(without.partition.c, 1024 * pilot.b());
    const Partition side{pilot.b() / 4, 512 * pilot.b()};
    pilot.borders.push_back({side.c, side.end, steps, steps});
    double least = INFINITY;
    for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2)
      least = std::min(least, work(pilot, {side, rho}));
    const bool expected = least <= 2.5 * work(pilot, without);
    EXPECT_EQ(cautious_pooling(pilot, bins).partition.has_end(), expected) << steps;
    ++(expected ? with_end : without_end);
    if (expected && least > work(pilot, without)) ++nearly;
  }
  EXPECT_GE(with_end, 1);
  EXPECT_GE(nearly, 1) << "no case shows the multiple";
  EXPECT_GE(without_end, 1);
}

// Where a wider end takes hardly more work, samples have fewer fireflies.
TEST(Pooling, HasTheWidestEndThatIsAboutAsGood) {
  int wide = 0, nearly = 0, narrow = 0;
  for (double steps = 4; steps <= 64; steps *= 1.125) {
    Pilot pilot = pilot_of({{1, 5000}, {400, 80}});
    const double b = pilot.b();
    for (const double c : borders_around(b))
      pilot.borders.push_back({.c = c, .steps_per_draw = 4096, .steps_per_draw_of_total = 4096});
    const Partition near{b / 4, 512 * b}, far{b / 4, 32'768 * b};
    pilot.borders.push_back({near.c, near.end, 4, 4});
    pilot.borders.push_back({far.c, far.end, steps, steps});
    const auto least = [&](Partition side) {
      double work_of_side = INFINITY;
      for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2)
        work_of_side = std::min(work_of_side, work(pilot, {side, rho}));
      return work_of_side;
    };
    const bool expected = least(far) <= 1.25 * std::min(least(near), least(far));
    const Partition chosen = cautious_pooling(pilot, bins).partition;
    EXPECT_EQ(chosen.end, expected ? far.end : near.end) << steps;
    ++(expected ? wide : narrow);
    if (expected && least(far) > least(near)) ++nearly;
  }
  EXPECT_GE(wide, 1);
  EXPECT_GE(nearly, 1) << "no case shows the quarter";
  EXPECT_GE(narrow, 1);
}

// Where the best leaves next to nothing to chains, what leaves less still is taken if it is not much dearer.
TEST(Pooling, LeavesHardlyAnyLightToChainsThatHardlyKnowIt) {
  int further = 0;
  for (const double draw : {1e3, 4e3, 16e3, 64e3}) {
    Pilot pilot = pilot_of({{1, 5000}, {2000, 100}});
    for (const double c : borders_around(pilot.b()))
      pilot.borders.push_back({.c = c, .steps_per_draw = draw, .steps_per_draw_of_total = draw});
    std::vector<Pooling> all = all_choices(pilot);
    const Pooling best =
        std::ranges::min(all, {}, [&](const Pooling& one) { return work(pilot, one); });
    ASSERT_TRUE(is_telling(pilot));
    ASSERT_GT(best.partition.c, 1024 * pilot.b()) << draw;
    const Pooling chosen = cautious_pooling(pilot, bins),
                  expected = by_cautious_rule(pilot).pooling;
    EXPECT_EQ(chosen.partition.c, expected.partition.c) << draw;
    EXPECT_EQ(chosen.samples_per_step, expected.samples_per_step) << draw;
    further += chosen.partition.c > best.partition.c ? 1 : 0;
  }
  EXPECT_GE(further, 1);
}

TEST(Pooling, IsLeftToSamplesFromABorderThatHasNoEnd) {
  constexpr double b = 3;
  EXPECT_TRUE(is_left_to_samples({.partition = {.c = 0x1p10 * b}}, b));
  EXPECT_FALSE(is_left_to_samples({.partition = {.c = 0x1p9 * b}}, b));
  EXPECT_FALSE(is_left_to_samples({.partition = {.c = 0x1p10 * b, .end = 0x1p15 * b}}, b));
}

}  // namespace
}  // namespace wander::test::cautious_pooling_test
