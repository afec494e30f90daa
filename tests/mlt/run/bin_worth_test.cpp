// What an error on a bin is worth.
#include "mlt/run/bin_worth.h"

#include <gtest/gtest.h>

#include <array>

namespace wander::test {
namespace {

// So much light on each bin, in very many paths that one sample found.
TrialLog light_on(const std::vector<double>& bins) {
  constexpr int paths = 100'000;
  TrialLog log;
  log.samples = 1;
  for (std::size_t j = 0; j < bins.size(); ++j)
    for (int k = 0; k < paths; ++k)
      log.found.push_back({0, static_cast<int>(j), bins[j] / paths, bins[j] / paths});
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
  const double floor = 0.2 * 10;  // of the mean
  for (const auto& [bin, light] : {std::pair{0, 1.0}, {2, 0.0}, {3, 29.0}})
    EXPECT_NEAR(worth(bin) / worth(1) * (light + floor) / (10 + floor), 1, 2e-3) << bin;
  EXPECT_NEAR((1 * worth(0) + 10 * worth(1) + 29 * worth(3)) / 40, 1, 1e-3) << "E_π[a]";
}

// One path has more light than all others: its bin is no brighter than a few samples make it, and all others are known as
// well as before.
TEST(BinWorth, DoesNotBelieveAFirefly) {
  const std::vector<double> light{4e3, 4e3, 4e4, 4e4};
  TrialLog plain = light_on(light), log = light_on(light);
  plain.samples = log.samples = 100'000;
  log.found.push_back({0, 0, 1e5, 1e5});
  const std::array groups{TrialFindings{&log, 0}}, others{TrialFindings{&plain, 0}};
  const BinWorth worth(std::array{2, 2}, groups), without(std::array{2, 2}, others);
  for (int j = 0; j < 4; ++j) EXPECT_NEAR(worth(j) / without(j), 1, 0.02) << j;
}

// Blocks of a large image are worth the same.
TEST(BinWorth, IsThatOfABlock) {
  TrialLog log;
  log.samples = 2;
  log.found = {{0, 0, 1, 1}, {1, 256 * 256 - 1, 3, 3}};
  const std::array groups{TrialFindings{&log, 0}};
  const BinWorth worth(std::array{256, 256}, groups);
  EXPECT_EQ(worth(0), worth(256 + 1));
  EXPECT_LT(worth(0), worth(2));
  EXPECT_LT(worth(256 * 256 - 1), worth(0));
}

}  // namespace
}  // namespace wander::test
