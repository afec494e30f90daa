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

bool goes_on() { return false; }

// 64 groups whose draws are kept for so many steps.
class Groups {
 public:
  explicit Groups(int kept) {
    for (std::uint32_t g = 0; g < 64; ++g) {
      TrialLog& log = logs_.emplace_back();
      Rng random(1, Purpose::test, g);
      random.start(static_cast<std::uint64_t>(kept));
      for (std::uint64_t i = 0; i < steps;) {
        const int bin = static_cast<int>(bins * std::pow(random.uniform(), 2));
        const double l = bin % 2 == 0 ? 1 : 9;  // so that w_M is 1/4 or 3/4
        for (int k = 0; k < kept && i < steps; ++k, ++i) {
          log.deposits.push_back({bin, 1, l});
          log.states.push_back({bin, 0, l});
        }
      }
      findings_.push_back({&log, 0, {1}});
    }
  }
  // Of the first so many.
  Pilot::Border border(std::size_t groups = 64) const {
    const auto first = std::span(findings_).first(groups);
    const BinWorth even(std::array{bins}, {});
    const Pilot pilot = pilot_of(first, even, {}, goes_on);
    Pilot after = pilot;
    after.steps_per_chain = static_cast<double>(steps);
    return borders_of(first, even, after, std::array{Partition{border_}}, goes_on).front();
  }

 private:
  static constexpr double border_ = 3;

  std::list<TrialLog> logs_;
  std::vector<TrialFindings> findings_;
};

// A sum of 8 variances of 64 groups is known to 8 % and better: the bounds are six of that.
TEST(StepsPerDrawOfFilms, IsHowLongAStateIsKept) {
  for (const int kept : {1, 5, 40})
    EXPECT_NEAR(Groups(kept).border().steps_per_draw / kept, 1, 0.5) << kept;
}

// Of one variance of 64 groups: 18 %; six of that are a factor of two.
TEST(StepsPerDrawOfFilms, AreThoseOfTheTotalToo) {
  for (const int kept : {1, 5, 40})
    EXPECT_NEAR(std::log2(Groups(kept).border().steps_per_draw_of_total / kept), 0, 1.1) << kept;
}

// Of draws that fall on one of two bins alike, half of the variance is lost to their mean.  Each is kept for
// five steps; of one variance of 256 groups 9 % are known.
TEST(StepsPerDrawOfFilms, IsThatOfDrawsOnFewBins) {
  constexpr int kept = 5;
  std::list<TrialLog> logs;
  std::vector<TrialFindings> groups;
  for (std::uint32_t g = 0; g < 256; ++g) {
    TrialLog& log = logs.emplace_back();
    Rng random(1, Purpose::test, 64 + g);
    random.start(0);
    for (std::uint64_t i = 0; i < steps / kept; ++i) {
      const int bin = random.uniform() < 0.5 ? 0 : 1;
      for (int k = 0; k < kept; ++k) {
        log.deposits.push_back({bin, 1, 1e9});
        log.states.push_back({bin, 0, 1e9});
      }
    }
    groups.push_back({&log, 0, {1}});
  }
  const BinWorth even(std::array{2}, {});
  Pilot pilot = pilot_of(groups, even, {}, goes_on);
  pilot.steps_per_chain = static_cast<double>(steps);
  const Pilot::Border border =
      borders_of(groups, even, pilot, std::array{Partition{1.0}}, goes_on).front();
  EXPECT_NEAR(border.steps_per_draw / kept, 1, 0.55);
}

TEST(StepsPerDrawOfFilms, IsNoMoreThanFourTimesTheStepsAndUsualWhereNothingIsKnown) {
  const Groups stuck(static_cast<int>(steps));
  EXPECT_LE(stuck.border().steps_per_draw, 4.01 * static_cast<double>(steps));
  EXPECT_GT(stuck.border().steps_per_draw, 2 * static_cast<double>(steps));
  EXPECT_EQ(stuck.border(2).steps_per_draw, usual_steps_per_draw);
}

Pilot::Border border(double c, double of_film, double of_total) {
  return {.c = c, .steps_per_draw = of_film, .steps_per_draw_of_total = of_total};
}

// Two borders, with the τ of each.
Pilot after(double steps, double first, double second) {
  return {.steps_per_chain = steps,
          .borders = {border(1, first, second), border(4, second, first)}};
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
  // No faster than the steps.
  EXPECT_NEAR(extrapolated(early, after(2000, 900, 200), 4000).borders[0].steps_per_draw, 1800,
              1e-9);
  EXPECT_DOUBLE_EQ(extrapolated(early, after(2000, 10, 200), 32'000).borders[0].steps_per_draw, 10);
  EXPECT_DOUBLE_EQ(extrapolated(early, after(500, 20, 200), 32'000).borders[1].steps_per_draw, 200);
}

// As the power of 1/2, of which 1/3 is left; and never more than the steps of a chain.
TEST(Pilots, ExpectOfShorterChainsThatTheyAreCaughtForLess) {
  const Pilot early = after(500, 20, 100), late = after(2000, 20, 200);
  const Pilot run = extrapolated(early, late, 250);
  EXPECT_DOUBLE_EQ(run.borders[0].steps_per_draw, 20);
  EXPECT_NEAR(run.borders[1].steps_per_draw, 100, 1e-9);
  EXPECT_NEAR(run.borders[0].steps_per_draw_of_total, 100, 1e-9);
  EXPECT_DOUBLE_EQ(extrapolated(Pilot{}, late, 100).borders[1].steps_per_draw, 100);
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
                 .borders = {border(1, 20, 20), border(4, 20, 20)}};
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

// A quarter of the light is hard, and samples and chains agree on it; but the chains know it so evenly.
double unvisited_if_as_even_as(double evenness) {
  Pilot pilot{
      .samples = 1000, .chains = {{}}, .steps_per_chain = 500, .borders = {border(1, 20, 20)}};
  pilot.borders[0].evenness = evenness;
  for (int i = 0; i < 1000; ++i) pilot.chains[0].add(i % 4 == 0 ? 1e9 : 1e-9);
  for (int i = 0; i < 1024; ++i) pilot.found.add(i % 4 == 0 ? 1e6 : 1e-6, i % 4 == 0 ? 1 : 1e12);
  return extrapolated(pilot, pilot, 500).borders[0].unvisited;
}

TEST(Pilots, ExpectLittleOfLightThatFewChainsKnow) {
  EXPECT_EQ(unvisited_if_as_even_as(1), 0);
  EXPECT_EQ(unvisited_if_as_even_as(0.5), 0) << "noise";
  EXPECT_NEAR(unvisited_if_as_even_as(0.25), 0.25 * 0.5, 0.005);
}

// Of sixteen chains one alone has been beyond the border, on a bin of its own; or half of them have, or all on many bins.
Pilot::Border border_where(PilotSteps steps, int chains, int bins_of_chain) {
  std::list<TrialLog> logs;
  std::vector<TrialFindings> groups;
  for (int g = 0; g < 16; ++g) {
    TrialLog& log = logs.emplace_back();
    for (int i = 0; i < 64; ++i) {
      const double l = g < chains && i < 32 ? 1e6 : 1e-6;
      const int bin = l > 1 ? (g + i % bins_of_chain) % bins : 0;
      log.deposits.push_back({bin, 1, l});
      log.states.push_back({bin, 0, l});
    }
    groups.push_back({&log, 0, {1}});
  }
  const BinWorth even(std::array{bins}, {});
  Pilot pilot = pilot_of(groups, even, {}, goes_on);
  pilot.steps_per_chain = static_cast<double>(steps.so_far);
  pilot.steps_in_all = static_cast<double>(steps.in_all);
  return borders_of(groups, even, pilot, std::array{Partition{1.0}}, goes_on).front();
}
constexpr PilotSteps of_long{steps_of_long_pilot, steps_of_long_pilot},
    of_short{steps_of_long_pilot - 1, steps_of_long_pilot - 1},
    early_of_long{steps_of_long_pilot / 4, steps_of_long_pilot};
double evenness_of(PilotSteps steps, int chains, int bins_of_chain) {
  return border_where(steps, chains, bins_of_chain).evenness;
}

TEST(Pilots, AskLongChainsHowEvenlyTheyKnowTheHardLight) {
  EXPECT_LT(evenness_of(of_long, 1, 1), 0.1);
  EXPECT_GE(evenness_of(of_long, 8, 1), 0.5);
  EXPECT_NEAR(evenness_of(of_long, 16, bins), 1, 1e-12);
  EXPECT_EQ(evenness_of(of_short, 1, 1), 1) << "short";
}

// Where one alone differs, nothing does but for it.
TEST(Pilots, CountTheChainThatIsFarthestOffIfItIsLong) {
  EXPECT_GT(border_where(of_long, 1, 1).steps_per_draw, 1000);
  EXPECT_LT(border_where(of_short, 1, 1).steps_per_draw,
            border_where(of_long, 1, 1).steps_per_draw / 10);
}

// Or the chain that is farthest off, left out of the early part alone, would show as growth of τ.
TEST(Pilots, CountItInTheEarlyPartToo) {
  const Pilot::Border early = border_where(early_of_long, 1, 1),
                      late = border_where({early_of_long.so_far, early_of_long.so_far}, 1, 1);
  EXPECT_GT(early.steps_per_draw, 10 * late.steps_per_draw);
  EXPECT_GT(early.steps_per_draw_of_total, 10 * late.steps_per_draw_of_total);
}

// Nearly all light lies beyond 100, where no chain was; but beyond 1 half of the states are.
TEST(Pilots, CountWhatIsUnvisitedBeyondAnyBorder) {
  Pilot pilot{.samples = 1000,
              .chains = {{}},
              .steps_per_chain = 500,
              .borders = {border(1, 20, 20), border(100, 20, 20), border(1, 20, 20)}};
  pilot.borders[2].end = 4;
  for (int i = 0; i < 100; ++i) pilot.chains[0].add(i < 50 ? 1e-9 : 10);
  for (int i = 0; i < 80; ++i) pilot.found.add(10);
  for (int i = 0; i < 2; ++i) pilot.found.add(1e6);  // nearly all, also of one of them
  const Pilot late = extrapolated(pilot, pilot, 500);
  EXPECT_NEAR(late.borders[1].unvisited, 1, 0.15);
  EXPECT_GE(late.borders[0].unvisited, late.borders[1].unvisited);
  EXPECT_EQ(late.borders[2].unvisited, 0) << "what lies beyond an end is no matter of the chains";
}

// What chains do not know before an end says nothing of what they know beyond the next border.
TEST(Pilots, CountWhatIsUnvisitedBeforeAnEndByItself) {
  Pilot pilot{.samples = 1000,
              .chains = {{}},
              .steps_per_chain = 500,
              .borders = {border(100, 20, 20), border(1, 20, 20)}};
  pilot.borders[1].end = 64;
  for (int i = 0; i < 100; ++i) pilot.chains[0].add(i < 50 ? 1e-9 : 1e6);
  pilot.found.add(3, 1e6 / 3);  // half of the light
  for (int i = 0; i < 2; ++i) pilot.found.add(1e6);
  const Pilot late = extrapolated(pilot, pilot, 500);
  EXPECT_GT(late.borders[1].unvisited, 0.3);
  EXPECT_EQ(late.borders[0].unvisited, 0);
}

TEST(Pilots, HaveSeedsOfTheirOwn) {
  for (const std::uint64_t seed : {0ull, 1ull, 2ull, 77ull, ~0ull}) {
    EXPECT_NE(seed_of_pilot(seed), seed);
    EXPECT_NE(seed_of_pilot(seed), seed_of_pilot(seed + 1));
  }
}

// Of strata, each state stands for light of its own; and of an image each for what its bin is worth.
TEST(Pilots, AddUpWhatTheirGroupsFound) {
  TrialLog log;
  log.samples = 50;
  log.found = {{0, 0, 4.75, 4.75}, {0, 1, 5, 5}, {7, 1, 2.5, 5}};  // the last is half a sample
  log.states = {{0, 0, 4}, {1, 1, 4}};
  const TrialLog other = log;
  const std::vector<TrialFindings> groups{{&log, 300, {0.25, 0.5}}, {&other, 300, {0.25, 0.5}}};
  const Pilot pilot = pilot_of(groups, BinWorth(std::array{2}, groups), {}, goes_on);
  EXPECT_EQ(pilot.samples, 100);
  EXPECT_EQ(pilot.rays, 600);
  EXPECT_EQ(pilot.b(), 2 * (4.75 + 5 + 2.5) / 100);
  EXPECT_EQ(pilot.found.count(), 5);
  EXPECT_EQ(pilot.chains.size(), 2);
  EXPECT_EQ(pilot.states().count(), 1.5);
  EXPECT_TRUE(pilot.borders.empty()) << "no steps";
  const BinWorth worth(std::array{1, 2}, groups);
  const Pilot of_image = pilot_of(groups, worth, {}, goes_on);
  EXPECT_EQ(of_image.b(), pilot.b());
  EXPECT_DOUBLE_EQ(of_image.states().count(), 2 * (0.25 * worth(0) + 0.5 * worth(1)));
  // Without the path that brought most.
  EXPECT_GT(4.75 * worth(0), 5 * worth(1));
  const RatioHistogram light = of_image.light_of_samples();
  EXPECT_DOUBLE_EQ(light.count(), worth(0) * 1 + worth(1) * (2 + 2 * 0.5));
}

}  // namespace
}  // namespace wander::test::pilot_test
