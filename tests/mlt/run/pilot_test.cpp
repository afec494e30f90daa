// What a pilot learns of its groups.
#include "mlt/run/pilot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <list>

#include "core/rng.h"

namespace wander::test {
namespace {

constexpr int bins = 8;
constexpr std::uint64_t steps = 800;

// Films of 64 groups whose draws are kept for so many steps.
class Groups {
 public:
  explicit Groups(int kept) {
    for (std::uint32_t g = 0; g < 64; ++g) {
      GroupFilm& film = films_.emplace_back(bins, 4);
      Rng random(1, Purpose::test, g);
      random.start(static_cast<std::uint64_t>(kept));
      for (std::uint64_t i = 0; i < steps;) {
        const int bin = static_cast<int>(bins * std::pow(random.uniform(), 2));
        for (int k = 0; k < kept && i < steps; ++k, ++i) film.add(2, bin, 1);
      }
      findings_.push_back({.seeds = &tally_,
                           .of_seeds = &tally_,
                           .evidence = &evidence_,
                           .film = &film,
                           .parts = nullptr,
                           .scale = 1});
    }
  }
  std::span<const GroupFindings> findings() const { return findings_; }

 private:
  SeedTally tally_{4};
  SeedEvidence evidence_{1, bins};
  std::list<GroupFilm> films_;
  std::vector<GroupFindings> findings_;
};

// A sum of 8 variances of 64 groups is known to 8 % and better: the bounds are six of that.
TEST(StepsPerDrawOfFilm, IsHowLongAStateIsKept) {
  for (const int kept : {1, 5, 40}) {
    const Groups groups(kept);
    EXPECT_NEAR(steps_per_draw_of_film(groups.findings(), steps) / kept, 1, 0.5) << kept;
  }
}

TEST(StepsPerDrawOfFilm, IsNoMoreThanFourTimesTheStepsAndUsualWhereNothingIsKnown) {
  Groups stuck(static_cast<int>(steps));
  EXPECT_LE(steps_per_draw_of_film(stuck.findings(), steps), 4.01 * static_cast<double>(steps));
  EXPECT_GT(steps_per_draw_of_film(stuck.findings(), steps), 2 * static_cast<double>(steps));
  EXPECT_EQ(steps_per_draw_of_film(stuck.findings().first(1), steps), Pilot{}.steps_per_draw);
}

TEST(Pilots, HaveSeedsOfTheirOwn) {
  for (const std::uint64_t seed : {0ull, 1ull, 2ull, 77ull, ~0ull}) {
    EXPECT_NE(seed_of_pilot(seed), seed);
    EXPECT_NE(seed_of_pilot(seed), seed_of_pilot(seed + 1));
  }
}

TEST(Pilots, AddUpWhatTheirGroupsFound) {
  SeedTally tally(4);
  tally.samples = 50;
  SeedEvidence evidence(2, bins);
  evidence.ratios[0].add(3);
  evidence.ratios[1].add(5);
  evidence.ratios[1].add(5);
  RatioHistogram states;
  states.add(4);
  GroupFilm film(bins, 4);
  film.add(2, 1, 1);
  const GroupFindings group{.seeds = &tally,
                            .of_seeds = &tally,
                            .evidence = &evidence,
                            .film = &film,
                            .parts = nullptr,
                            .scale = 1,
                            .states = {{&states, 0.25}, {&states, 0.5}}};
  const Pilot pilot = pilot_of(std::vector{group, group}, 300, 0);
  EXPECT_EQ(pilot.samples, 100);
  EXPECT_EQ(pilot.rays, 300);
  EXPECT_EQ(pilot.found.count(), 6);
  ASSERT_EQ(pilot.states.size(), 2u);
  EXPECT_EQ(pilot.states[0].count(), 0.75);
  EXPECT_EQ(pilot.steps_per_draw, Pilot{}.steps_per_draw) << "no steps";
}

}  // namespace
}  // namespace wander::test
