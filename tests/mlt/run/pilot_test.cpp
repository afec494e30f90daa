// What a pilot learns of its groups.
#include "mlt/run/pilot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <list>

#include "core/rng.h"

namespace wander::test::pilot_test {
namespace {

constexpr int bins = 8;
constexpr std::uint64_t steps = 800;
constexpr double border = 3;

// Films of 64 groups whose draws are kept for so many steps.
class Groups {
 public:
  explicit Groups(int kept) {
    for (std::uint32_t g = 0; g < 64; ++g) {
      GroupFilm& film = films_.emplace_back(bins, 4);
      PooledParts& parts =
          parts_.emplace_back(Pooling{.partition = {border}}, std::array{bins}, 4, FilmLayout{});
      Rng random(1, Purpose::test, g);
      random.start(static_cast<std::uint64_t>(kept));
      for (std::uint64_t i = 0; i < steps;) {
        const int bin = static_cast<int>(bins * std::pow(random.uniform(), 2));
        const double l = bin % 2 == 0 ? 1 : 9;  // so that w_M is 1/4 or 3/4
        for (int k = 0; k < kept && i < steps; ++k, ++i) {
          film.add(2, bin, 1);
          parts.of_chains().add(2, bin, parts.partition().of_chains(l));
          states_.add(l);
        }
      }
      findings_.push_back({.seeds = &tally_,
                           .of_seeds = &tally_,
                           .evidence = &evidence_,
                           .film = &film,
                           .parts = {&parts, 1},
                           .scale = 1});
    }
  }
  std::span<const GroupFindings> findings() const { return findings_; }
  const RatioHistogram& states() const { return states_; }

 private:
  SeedTally tally_{4};
  SeedEvidence evidence_{1, bins};
  std::list<GroupFilm> films_;
  std::list<PooledParts> parts_;
  RatioHistogram states_;
  std::vector<GroupFindings> findings_;
};

// A sum of 8 variances of 64 groups is known to 8 % and better: the bounds are six of that.
TEST(StepsPerDrawOfFilms, IsHowLongAStateIsKept) {
  for (const int kept : {1, 5, 40}) {
    const Groups groups(kept);
    EXPECT_NEAR(border_of(groups.findings(), 0, groups.states(), steps).steps_per_draw / kept, 1,
                0.5)
        << kept;
  }
}

// Of one variance of 64 groups: 18 %; six of that are a factor of two.
TEST(StepsPerDrawOfFilms, AreThoseOfTheTotalToo) {
  for (const int kept : {1, 5, 40}) {
    const Groups groups(kept);
    const auto border = border_of(groups.findings(), 0, groups.states(), steps);
    EXPECT_NEAR(std::log2(border.steps_per_draw_of_total / kept), 0, 1.1) << kept;
  }
}

TEST(StepsPerDrawOfFilms, IsNoMoreThanFourTimesTheStepsAndUsualWhereNothingIsKnown) {
  Groups stuck(static_cast<int>(steps));
  EXPECT_LE(border_of(stuck.findings(), 0, stuck.states(), steps).steps_per_draw,
            4.01 * static_cast<double>(steps));
  EXPECT_GT(border_of(stuck.findings(), 0, stuck.states(), steps).steps_per_draw,
            2 * static_cast<double>(steps));
  EXPECT_EQ(border_of(stuck.findings().first(1), 0, stuck.states(), steps).steps_per_draw,
            usual_steps_per_draw);
}

// Two borders, with the τ of each.
Pilot after(double steps, double first, double second) {
  return {.steps_per_chain = steps, .borders = {{1, first, second}, {4, second, first}}};
}

TEST(Pilots, ExpectOfChainsThatDoNotMixThatTheyGoOnSo) {
  const Pilot early = after(500, 20, 100);
  // The first has mixed; τ of the second has grown as the steps to the power of 5/8, of which 1/2 is left.
  const double grown = 100 * std::pow(4, 0.625);
  const Pilot run = extrapolated(early, after(2000, 20, grown), 32'000);
  EXPECT_DOUBLE_EQ(run.borders[0].steps_per_draw, 20);
  EXPECT_NEAR(run.borders[1].steps_per_draw, 4 * grown, 1e-9);
  EXPECT_EQ(run.borders[1].c, 4);
  EXPECT_DOUBLE_EQ(run.borders[1].steps_per_draw_of_total, 20);
  EXPECT_NEAR(run.borders[0].steps_per_draw_of_total, 4 * grown, 1e-9);
  // No faster than the steps, and nothing is expected of a run that is shorter.
  EXPECT_NEAR(extrapolated(early, after(2000, 900, 200), 4000).borders[0].steps_per_draw, 1800,
              1e-9);
  EXPECT_DOUBLE_EQ(extrapolated(early, after(2000, 10, 200), 32'000).borders[0].steps_per_draw, 10);
  EXPECT_DOUBLE_EQ(extrapolated(early, after(2000, 20, 200), 100).borders[1].steps_per_draw, 100);
  EXPECT_DOUBLE_EQ(extrapolated(early, after(500, 20, 200), 32'000).borders[1].steps_per_draw, 200);
}

TEST(Pilots, ExpectNoGrowthWhereThereWasNoTimeToSeeIt) {
  for (const Pilot& early : {Pilot{}, after(2000, 10, 20)}) {
    const Pilot run = extrapolated(early, after(2000, 20, 200), 32'000);
    EXPECT_DOUBLE_EQ(run.borders[0].steps_per_draw, 20);
    EXPECT_DOUBLE_EQ(run.borders[1].steps_per_draw, 200);
  }
  EXPECT_TRUE(extrapolated(Pilot{}, Pilot{}, 32'000).borders.empty());
}

// Nearly all of what samples found lies beyond both borders; of the states of the chains less does.
TEST(Pilots, ExpectNothingOfChainsThatHaveNotComeToTheHardLight) {
  const auto unvisited = [](double hard_states) {
    const auto pilot = [&](double steps) {
      Pilot made{.samples = 1000,
                 .chains = {{}},
                 .steps_per_chain = steps,
                 .borders = {{1, 20, 20}, {4, 20, 20}}};
      for (int i = 0; i < 1000; ++i) made.chains[0].add(i < 1000 * hard_states ? 1e9 : 1e-9);
      for (int i = 0; i < 1000; ++i) made.found.add(1e6);
      for (int i = 0; i < 1024; ++i) made.found.add(1e-6);
      return made;
    };
    return extrapolated(pilot(500), pilot(2000), 32'000).borders[0].unvisited;
  };
  EXPECT_EQ(unvisited(1), 0);
  EXPECT_EQ(unvisited(0.8), 0) << "noise";
  EXPECT_NEAR(unvisited(0.25), 2 / 3., 0.001);
  EXPECT_NEAR(unvisited(0), 1, 0.001);
}

// Nearly all light lies beyond 100, where no chain was; but beyond 1 half of the states are.
TEST(Pilots, CountWhatIsUnvisitedBeyondAnyBorder) {
  Pilot pilot{.samples = 1000,
              .chains = {{}},
              .steps_per_chain = 500,
              .borders = {{1, 20, 20}, {100, 20, 20}}};
  for (int i = 0; i < 100; ++i) pilot.chains[0].add(i < 50 ? 1e-9 : 10);
  for (int i = 0; i < 80; ++i) pilot.found.add(10);
  for (int i = 0; i < 2; ++i) pilot.found.add(1e6);  // nearly all, also of one of them
  const Pilot late = extrapolated(pilot, pilot, 500);
  EXPECT_NEAR(late.borders[1].unvisited, 1, 0.15);
  EXPECT_GE(late.borders[0].unvisited, late.borders[1].unvisited);
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
                            .parts = {},
                            .scale = 1,
                            .states = {{&states, 0.25}, {&states, 0.5}}};
  const Pilot pilot = pilot_of(std::vector{group, group}, 300, 0);
  EXPECT_EQ(pilot.samples, 100);
  EXPECT_EQ(pilot.rays, 300);
  EXPECT_EQ(pilot.found.count(), 6);
  EXPECT_EQ(pilot.states().count(), 1.5);
  EXPECT_TRUE(pilot.borders.empty()) << "no steps";
}

}  // namespace
}  // namespace wander::test::pilot_test
