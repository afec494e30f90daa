// b of chains in strata, as those of `mmlt` are: a sum whose error knows what the samples share.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <list>
#include <numeric>
#include <utility>
#include <vector>

#include "core/rng.h"
#include "mlt/run/normalization.h"

namespace wander::test {
namespace {

// Groups of two strata; some of them are shown.
class StrataOfGroups {
 public:
  explicit StrataOfGroups(int groups, int with_second = 1 << 10) {
    Rng random(1, Purpose::test, 73);
    for (int g = 0; g < groups; ++g) {
      Held& group = held_.emplace_back();
      group.tally.samples = 100;
      for (std::size_t k = 0; k < (g < with_second ? 2 : 1); ++k)
        for (int i = 0; i < 30; ++i) {
          group.evidence.ratios[k].add(std::exp(static_cast<double>(k) + 2 * random.uniform()));
          group.states[k].add(std::exp(static_cast<double>(k) + 0.5 + 2 * random.uniform()));
        }
    }
  }
  Constant bridge_of(std::size_t first, std::size_t end) {
    std::vector<std::size_t> strata(end - first);
    std::iota(strata.begin(), strata.end(), first);
    return bridge_of(strata);
  }
  Constant bridge_of(const std::vector<std::size_t>& strata) {
    std::vector<GroupFindings> findings;
    std::list<SeedEvidence> kept;
    for (Held& group : held_) {
      SeedEvidence& evidence = kept.emplace_back(static_cast<int>(strata.size()), 1);
      std::vector<StateRatios> states;
      for (std::size_t k = 0; k < strata.size(); ++k) {
        evidence.ratios[k] = group.evidence.ratios[strata[k]];
        states.push_back({&group.states[strata[k]], 1.0});
      }
      findings.push_back(
          {&group.tally, &group.tally, &evidence, &group.film, {}, 1.0, std::move(states), {}});
    }
    return constants(findings).bridge;
  }

 private:
  struct Held {
    SeedTally tally{3};
    SeedEvidence evidence{2, 1};
    GroupFilm film{1, 3};
    std::array<RatioHistogram, 2> states;
  };
  std::list<Held> held_;
};

// b of all is the sum over strata, and so it is without each group.
TEST(Constants, OfStrataAreSumsWithoutEachGroupToo) {
  StrataOfGroups groups(8);
  const Constant first = groups.bridge_of(0, 1), second = groups.bridge_of(1, 2),
                 both = groups.bridge_of(0, 2);
  ASSERT_TRUE(both.failure.empty()) << both.failure;
  EXPECT_DOUBLE_EQ(both.b.value, first.b.value + second.b.value);
  for (std::size_t g = 0; g < 8; ++g) {
    EXPECT_DOUBLE_EQ(both.without[g], first.without[g] + second.without[g]);
    EXPECT_NE(second.without[g], second.b.value);
  }
}

// What the same samples found in two strata is known by as many events as each of them; by more, where other samples found it.
TEST(Constants, OfStrataAreKnownByTheSamplesThatFoundThem) {
  StrataOfGroups groups(8);
  const Constant once = groups.bridge_of(1, 2), twice = groups.bridge_of({1, 1});
  EXPECT_DOUBLE_EQ(twice.b.value, 2 * once.b.value);
  EXPECT_NEAR(twice.effective_samples, once.effective_samples, 1e-9 * once.effective_samples);
  const Constant first = groups.bridge_of(0, 1), both = groups.bridge_of(0, 2);
  EXPECT_LT(both.b.value / std::sqrt(both.effective_samples),
            0.95 * (first.b.value / std::sqrt(first.effective_samples) +
                    once.b.value / std::sqrt(once.effective_samples)));
}

// What one group alone found is missing without it, and says nothing against what all found.
TEST(Constants, OfAStratumThatOneGroupFoundHaveAnError) {
  StrataOfGroups groups(8, 1);
  const Constant first = groups.bridge_of(0, 1), second = groups.bridge_of(1, 2),
                 both = groups.bridge_of(0, 2);
  EXPECT_DOUBLE_EQ(both.without[0], first.without[0]);
  EXPECT_GT(both.without[1], first.without[1] + 0.9 * second.b.value);
  EXPECT_GT(both.b.standard_error, 0.9 * second.b.value);
  EXPECT_LT(both.b.standard_error, 1.1 * second.b.value + first.b.standard_error);
  EXPECT_GT(both.degrees_of_freedom, 0);
  EXPECT_FALSE(std::isfinite(second.b.standard_error)) << "it is all that there is";
}

}  // namespace
}  // namespace wander::test
