// Light that chains did not meet, by classes, of findings made up by hand; and what the bridge makes of it.
#include "mlt/run/unmet_light.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <vector>

#include "mlt/run/bridge.h"
#include "mlt/run/normalization.h"
#include "tests/mlt/run/bridge_sides.h"

namespace wander::test {
namespace unmet_light_test {
namespace {

constexpr PathClass easy = 0b10, hard = 0b101, rare = 0b1101;
constexpr int groups = 8;
constexpr double states_of_group = 100;

// The light of each class that samples found, and states showed, of a group.
struct Found {
  double samples[3], states[3];
};

class Groups {
 public:
  void add(const Found& found) {
    SeedEvidence& evidence = evidence_.emplace_back(1, 1);
    RatioHistogram& states = states_.emplace_back();
    for (int i = 0; i < static_cast<int>(states_of_group); ++i) states.add(1);
    GroupFindings group{nullptr, nullptr, &evidence, nullptr, {}, 1, {{&states, 1}}};
    for (std::size_t c = 0; c < 3; ++c) {
      const PathClass code = std::array{easy, hard, rare}[c];
      *entries_of(evidence.by_class, evidence.classes.index(code)) += found.samples[c];
      if (found.states[c] > 0) group.classes.push_back({code, found.states[c]});
    }
    findings_.push_back(group);
  }
  double unmet() const { return unmet_light(findings_); }
  std::vector<GroupFindings>& findings() { return findings_; }

 private:
  std::deque<SeedEvidence> evidence_;
  std::deque<RatioHistogram> states_;
  std::vector<GroupFindings> findings_;
};

// Group g is `first`, all others are `rest`.
Groups made(int first, const Found& of_first, const Found& rest) {
  Groups all;
  for (int g = 0; g < groups; ++g) all.add(g < first ? of_first : rest);
  return all;
}

TEST(UnmetLight, IsThatOfClassesThatNoGroupOrOneMet) {
  const Found none{{0.7, 0.3, 0}, {1, 0, 0}}, some{{0.7, 0.3, 0}, {0.5, 0.5, 0}};
  EXPECT_DOUBLE_EQ(made(0, some, none).unmet(), 0.3);
  EXPECT_DOUBLE_EQ(made(1, some, none).unmet(), 0.3 - 0.5 / groups);
  EXPECT_EQ(made(2, some, none).unmet(), 0) << "how two differ from the rest tells its error";
  EXPECT_EQ(made(groups, some, none).unmet(), 0);
}

// What few states are to be expected of may be met by none, however well chains mix.
TEST(UnmetLight, IsNoneOfClassesThatHardlyAnyStateIsExpectedOf) {
  const Found below{{0.99, 0.0099, 0.0001}, {0.99, 0.01, 0}},
      above{{0.97, 0.01, 0.02}, {0.99, 0.01, 0}};
  EXPECT_EQ(made(0, below, below).unmet(), 0);
  EXPECT_DOUBLE_EQ(made(0, above, above).unmet(), 0.02);
}

// As where what chains show has no class: none is to be missed.
TEST(UnmetLight, IsNoneWhereStatesHaveNoClass) {
  Groups all = made(0, {}, {{0.7, 0.3, 0}, {0, 0, 0}});
  EXPECT_EQ(all.unmet(), 0);
}

// Chains that know b better than samples do are leaned on; of light that they have not met, no more than their groups'
// number allows.
TEST(UnmetLight, MakesTheBridgeLeanOnSamples) {
  const auto sides = bridge_sides::simulate({.sigma = 2, .samples = 20'000, .states = 320'000}, 1);
  const BridgeFit usual = bridge(sides.data()), doubtful = bridge(sides.data(), 0.1);
  ASSERT_TRUE(usual.failure.empty() && doubtful.failure.empty());
  EXPECT_LT(doubtful.balance, 0.1 * usual.balance);
  EXPECT_GT(jackknife_error(doubtful.without), jackknife_error(usual.without));
}

// Of findings with the sides of a bridge, a tenth of whose light is of a class that no chain met, or none.
double error_of_bridge(const bridge_sides::Sides& sides, double light_unmet) {
  struct Held {
    SeedTally tally{4};
    SeedEvidence evidence{1, 2};
    GroupFilm film{2, 4};
  };
  std::deque<Held> held;
  std::vector<GroupFindings> findings;
  for (std::size_t g = 0; g < bridge_sides::groups; ++g) {
    Held& group = held.emplace_back();
    group.tally.samples = static_cast<std::uint64_t>(sides.samples_of_group);
    for (const double l : sides.found[g].values) {
      group.tally.total += l;
      group.tally.total_squares += l * l;
      group.evidence.film[0] += l;
    }
    group.evidence.ratios[0] = sides.found[g].ratios;
    *entries_of(group.evidence.by_class, group.evidence.classes.index(easy)) += 1 - light_unmet;
    *entries_of(group.evidence.by_class, group.evidence.classes.index(rare)) += light_unmet;
    group.film.add(2, 0, 1);
    findings.push_back({&group.tally,
                        &group.tally,
                        &group.evidence,
                        &group.film,
                        {},
                        1,
                        {{&sides.states[g].ratios, 1}},
                        {{easy, 1}}});
  }
  return constants(findings).bridge.b.standard_error;
}

TEST(UnmetLight, IsInTheErrorOfTheConstant) {
  const auto sides = bridge_sides::simulate({.sigma = 2, .samples = 20'000, .states = 320'000}, 1);
  EXPECT_GT(error_of_bridge(sides, 0.1), 1.2 * error_of_bridge(sides, 0));
}

}  // namespace
}  // namespace unmet_light_test
}  // namespace wander::test
