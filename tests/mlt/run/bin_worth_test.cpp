// What an error on a bin is worth.
#include "mlt/run/bin_worth.h"

#include <gtest/gtest.h>

#include <array>

namespace wander::test {
namespace {

// So much light on each bin, in paths of a thousandth of it that one sample found.
TrialLog light_on(const std::vector<double>& bins) {
  TrialLog log;
  log.samples = 1;
  for (std::size_t j = 0; j < bins.size(); ++j)
    for (int k = 0; k < 1000; ++k)
      log.found.push_back({0, static_cast<int>(j), bins[j] / 1000, bins[j] / 1000});
  return log;
}

TEST(BinWorth, IsEvenOnACurveAndOnADarkImage) {
  const TrialLog log = light_on({1, 100}), dark;
  const std::array groups{TrialFindings{&log, 0}}, nothing{TrialFindings{&dark, 0}};
  EXPECT_TRUE(BinWorth(std::array{2}, groups).is_even());
  EXPECT_EQ(BinWorth(std::array{2}, groups)(1), 1);
  EXPECT_EQ(BinWorth(std::array{1, 2}, nothing)(1), 1);
}

TEST(BinWorth, OfAnImageFallsAsItsLightButNotOfWhatIsDark) {
  const TrialLog log = light_on({1, 10, 0, 29});
  const std::array groups{TrialFindings{&log, 0}};
  const BinWorth worth(std::array{2, 2}, groups);
  const double floor = 0.05 * 10;  // of the mean
  for (const auto& [bin, light] : {std::pair{0, 1.0}, {2, 0.0}, {3, 29.0}})
    EXPECT_NEAR(worth(bin) / worth(1), (10 + floor) / (light + floor), 1e-3) << bin;
  EXPECT_NEAR((1 * worth(0) + 10 * worth(1) + 29 * worth(3)) / 40, 1, 1e-3) << "E_π[a]";
}

// One path has a thousand times the light of all others: its bin is no brighter than a few samples make it.
TEST(BinWorth, DoesNotBelieveAFirefly) {
  TrialLog log = light_on({1, 1, 1, 1});
  log.samples = 1000;
  log.found.push_back({0, 0, 4000, 4000});
  const std::array groups{TrialFindings{&log, 0}};
  const BinWorth worth(std::array{2, 2}, groups);
  // 64 beside 1, and 79 beside 1 if it were believed, for then the floor is higher, too.
  EXPECT_GT(worth(0), worth(1) / 50);
}

// Blocks of a large image are worth the same.
TEST(BinWorth, IsThatOfABlock) {
  TrialLog log;
  log.samples = 2;
  log.found = {{0, 0, 1, 1}, {1, 64 * 64 - 1, 3, 3}};
  const std::array groups{TrialFindings{&log, 0}};
  const BinWorth worth(std::array{64, 64}, groups);
  EXPECT_EQ(worth(0), worth(64 + 1));
  EXPECT_LT(worth(0), worth(2));
  EXPECT_LT(worth(64 * 64 - 1), worth(0));
}

}  // namespace
}  // namespace wander::test
