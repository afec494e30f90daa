// How chains differ, and how the paths of a sample come together: against sums written out.
#include "mlt/run/deposit_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <list>
#include <vector>

#include "core/rng.h"
#include "mlt/run/partition.h"
#include "mlt/run/sample_spread.h"

namespace wander::test::deposit_spread_test {
namespace {

constexpr int bins = 6;
constexpr double c = 3;

struct Trial {
  std::list<TrialLog> logs;
  std::vector<TrialFindings> groups;

  TrialLog& add() {
    TrialLog& log = logs.emplace_back();
    groups.push_back({&log, 0});
    return log;
  }
};

// Five groups with deposits on an image of which some blocks are bright, and one with none.
Trial trial() {
  Trial made;
  Rng random(1, Purpose::test, 6);
  for (std::uint64_t g = 0; g < 5; ++g) {
    TrialLog& log = made.add();
    random.start(g);
    for (int i = 0; i < 40; ++i) {
      const int bin = static_cast<int>(bins * random.uniform());
      const double weight = random.uniform(), ratio = 10 * random.uniform();
      log.deposits.push_back({bin, weight, ratio});
    }
    for (; log.samples < 20; ++log.samples)
      for (int k = 0; k < 3; ++k) {
        const int bin = static_cast<int>(bins * random.uniform());
        const double light = 1 + 20.0 * bin * random.uniform();
        log.found.push_back({log.samples, bin, light, light});
      }
  }
  made.add();
  return made;
}

struct Shares {
  std::array<double, bins> all{}, hard{};
};
Shares shares(const TrialLog& log) {
  Shares of;
  double mass = 0;
  for (const auto& deposit : log.deposits) mass += deposit.weight;
  for (const auto& [bin, weight, ratio] : log.deposits) {
    of.all[static_cast<std::size_t>(bin)] += weight / mass;
    of.hard[static_cast<std::size_t>(bin)] += weight / mass * ratio / (ratio + c);
  }
  return of;
}
double variance_of(const std::vector<double>& squares) {
  double all = 0;
  for (const double square : squares) all += square;
  return all / (static_cast<double>(squares.size()) - 1);
}
// But for the largest, over all but two.
double variance_but_for_one(const std::vector<double>& squares) {
  double all = 0;
  for (const double square : squares) all += square;
  return (all - std::ranges::max(squares)) / (static_cast<double>(squares.size()) - 2);
}

TEST(DepositSpread, IsTheVarianceBetweenGroups) {
  const Trial made = trial();
  const BinWorth worth(std::array{2, 3}, made.groups);
  const DepositSpread spread =
      deposit_spreads(made.groups, worth, std::array{Partition{1.0}, Partition{c}}).back();
  std::vector<Shares> groups;
  for (const TrialLog& log : made.logs)
    if (!log.deposits.empty()) groups.push_back(shares(log));
  std::array<double, bins> mean{};
  double mean_total = 0, of_worth = 0, squared_mean = 0;
  for (int j = 0; j < bins; ++j) {
    const auto bin = static_cast<std::size_t>(j);
    for (const Shares& group : groups) {
      mean[bin] += group.hard[bin] / 5;
      of_worth += worth(j) * group.all[bin] / 5;
    }
    mean_total += mean[bin];
    squared_mean += worth(j) * mean[bin] * mean[bin];
  }
  std::vector<double> film, total;
  for (const Shares& group : groups) {
    double square = 0, sum = 0;
    for (int j = 0; j < bins; ++j) {
      const auto bin = static_cast<std::size_t>(j);
      square += worth(j) * std::pow(group.hard[bin] - mean[bin], 2);
      sum += group.hard[bin];
    }
    film.push_back(square);
    total.push_back(std::pow(sum - mean_total, 2));
  }
  EXPECT_NEAR(spread.worth, of_worth, 1e-12);
  EXPECT_NEAR(spread.film.of_all, variance_of(film) / of_worth, 1e-12);
  EXPECT_NEAR(spread.film.but_for_one, variance_but_for_one(film) / of_worth, 1e-12);
  EXPECT_NEAR(spread.squared_mean, squared_mean / of_worth, 1e-12);
  EXPECT_NEAR(spread.total.of_all, variance_of(total), 1e-12);
  EXPECT_NEAR(spread.total.but_for_one, variance_but_for_one(total), 1e-12);
  EXPECT_NEAR(spread.evenness, evenness(film), 1e-12);
}

TEST(DepositSpread, IsEvenWhereGroupsAreAlike) {
  EXPECT_DOUBLE_EQ(evenness(std::array{3.0, 3.0, 3.0}), 1);
  EXPECT_DOUBLE_EQ(evenness(std::array{0.0, 7.0, 0.0, 0.0}), 0.25);
  EXPECT_DOUBLE_EQ(evenness(std::array{1.0, 3.0}), 0.8);
  EXPECT_EQ(evenness(std::array{0.0, 0.0}), 1) << "nothing differs";
}

TEST(DepositSpread, IsNotKnownOfTwoGroups) {
  Trial made = trial();
  made.groups.erase(made.groups.begin() + 2, made.groups.end() - 1);
  const BinWorth even(std::array{bins}, {});
  EXPECT_TRUE(deposit_spreads(made.groups, even, std::array{Partition{c}}).empty());
}

bool goes_on() { return false; }

double together(std::span<const TrialFindings> groups, const BinWorth& worth) {
  return paths_together(groups, worth, std::array{Partition{c}}, goes_on).front();
}

TEST(PathsOfASample, AreOneWhereTheyFallOnOneBin) {
  const BinWorth even(std::array{bins}, {});
  Trial made;
  TrialLog& log = made.add();
  log.found = {{0, 1, 2, 2}, {0, 2, 3, 3}, {1, 1, 2, 2}, {2, 3, 5, 5}};
  EXPECT_EQ(together(made.groups, even), 1) << "two of a sample, on different bins";
  // x = 6/5 alone, and 6/5 and 3/2 of one sample on one bin.
  log.found = {{0, 1, 2, 2}, {1, 1, 2, 2}, {1, 1, 3, 3}, {1, 2, 3, 3}};
  const double alone = 1.2 * 1.2 * 2 + 1.5 * 1.5 * 2;
  EXPECT_NEAR(together(made.groups, even), (alone + 2 * 1.2 * 1.5) / alone, 1e-12);
  EXPECT_EQ(together({}, even), 1);
}

TEST(PathsOfASample, AreLeftWhenNobodyWantsToKnowAnyMore) {
  const BinWorth even(std::array{bins}, {});
  Trial made;
  TrialLog& log = made.add();
  for (std::uint32_t i = 0; i < 100; ++i) {
    log.found.push_back({i, 1, 2, 2});
    log.found.push_back({i, 1, 3, 3});
  }
  int asked = 0;
  const auto is_over = [&asked] { return ++asked == 3; };
  EXPECT_EQ(paths_together(made.groups, even, std::array{Partition{c}}, is_over).size(), 1);
  EXPECT_EQ(asked, 3);
}

TEST(PathsOfASample, CountAsTheirBinIsWorth) {
  Trial made;
  TrialLog& log = made.add();
  log.samples = 2;
  log.found = {{0, 0, 1, 1}, {0, 0, 1, 1}, {1, 1, 4, 4}};
  const BinWorth worth(std::array{1, 2}, made.groups);
  const double x = 0.75, y = 4 * 3 / 7.0;
  const double alone = 2 * worth(0) * x * x + worth(1) * y * y;
  EXPECT_NEAR(together(made.groups, worth), 1 + 2 * worth(0) * x * x / alone, 1e-12);
}

TEST(PathsOfASample, AreAskedWithEachBorderByItself) {
  const BinWorth even(std::array{bins}, {});
  Trial made;
  TrialLog& log = made.add();
  log.found = {{0, 2, 2, 1}, {0, 1, 2, 2}, {0, 2, 3, 9}, {1, 1, 7, 3}, {1, 1, 3, 30}};
  const std::array borders{Partition{c}, Partition{100 * c}, Partition{c / 8},
                           Partition{c / 8, 4 * c}};
  const std::vector<double> found = paths_together(made.groups, even, borders, goes_on);
  ASSERT_EQ(found.size(), borders.size());
  for (std::size_t k = 0; k < borders.size(); ++k)
    EXPECT_EQ(found[k], paths_together(made.groups, even, std::array{borders[k]}, goes_on).front());
  // On bin 2 one pair of the first sample, on bin 1 one of the second.
  const Partition side = borders[1];
  const auto light = [&](const TrialLog::Found& path) {
    return path.light * side.of_samples(path.ratio);
  };
  double alone = 0;
  for (const TrialLog::Found& path : log.found) alone += light(path) * light(path);
  const double pairs =
      light(log.found[0]) * light(log.found[2]) + light(log.found[3]) * light(log.found[4]);
  EXPECT_NEAR(found[1], 1 + 2 * pairs / alone, 1e-12);
}

}  // namespace
}  // namespace wander::test::deposit_spread_test
