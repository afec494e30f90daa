// Budgets of time, under a clock that goes on with the work and with nothing else: what counts, how
// far they are overrun, and that other work on the machine takes nothing of processor time.
#include <gtest/gtest.h>

#include <atomic>

#include "lab/render.h"
#include "lab/sample_film.h"
#include "mutations/catalogue.h"
#include "tests/lab/counting_run.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

// Seconds of work; the wall sees `slowdown` times as much.
class WorkClock : public Clock {
 public:
  Moment now() const override {
    const double work = static_cast<double>(nanoseconds_.load()) * 1e-9;
    return {slowdown * work, work};
  }
  static void work(double seconds) {
    nanoseconds_ += static_cast<std::uint64_t>(std::llround(1e9 * seconds));
  }
  double slowdown = 1;

 private:
  static inline std::atomic<std::uint64_t> nanoseconds_ = 0;
};

constexpr double per_seed = 5e-6, per_step = 2e-6, per_group_at_the_end = 4e-4;
constexpr double the_end = 64 * per_group_at_the_end;  // 26 ms

// Chains whose work takes time.
class WorkingGroup : public PathGroup<Flat, Family> {
 public:
  using Base = PathGroup<Flat, Family>;
  using Base::Base;

  void add_seeds(std::uint64_t count) {
    Base::add_seeds(count);
    WorkClock::work(per_seed * static_cast<double>(count));
  }
  void advance(std::uint64_t count) {
    Base::advance(count);
    WorkClock::work(per_step * static_cast<double>(count));
  }
  void deliver(GroupsFilm& film, MutationStatistics& statistics, ChainDraws& draws) const {
    Base::deliver(film, statistics, draws);
    WorkClock::work(per_group_at_the_end);
  }
};

Session session_of(const Clock& clock, const Budget& budget) {
  Session session;
  session.budget = budget;
  session.threads = 2;
  session.clock = &clock;
  return session;
}

Rendering by_chains(const Session& session, const ChainSettings& settings = {}) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  return ChainRenderer<Flat, WorkingGroup>(space, make_family({}, space.max_vertices()), session,
                                           settings)
      .render("mlt");
}

Rendering by_samples(const Session& session) {
  const std::array shape{20};
  return sample_film("made", shape, 4, session, [] {
    return [](Rng& rng, Contributions& found) {
      WorkClock::work(3e-6);
      found.push_back({3, 1, static_cast<int>(20 * rng.uniform()), 1});
    };
  });
}

using Method = Rendering (*)(const Session&);
class TimeBudgets : public ::testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Methods, TimeBudgets,
                         ::testing::Values(&by_samples, [](const Session& session) {
                           return by_chains(session);
                         }));

TEST_P(TimeBudgets, AreMetWithinAFewPercent) {
  const WorkClock clock;
  for (const double seconds : {0.25, 0.6}) {
    const Rendering r = GetParam()(session_of(clock, TimeBudget{seconds}));
    EXPECT_TRUE(r.complete);
    EXPECT_LT(r.seconds, 1.05 * seconds);
    EXPECT_GT(r.seconds, 0.9 * seconds);
  }
}

TEST_P(TimeBudgets, OfProcessorTimeDoNotSeeTheWall) {
  WorkClock clock;
  clock.slowdown = 4;
  const Rendering r = GetParam()(session_of(clock, TimeBudget{0.3, TimeKind::processor}));
  EXPECT_LT(r.processor_seconds, 1.05 * 0.3);
  EXPECT_GT(r.processor_seconds, 0.9 * 0.3);
  EXPECT_NEAR(r.seconds, 4 * r.processor_seconds, 1e-6);
}

// What came before the run was made, such as the scene, is in the budget.
TEST_P(TimeBudgets, BeginWhereTheSessionSays) {
  const WorkClock clock;
  Session session = session_of(clock, TimeBudget{0.3});
  session.begun = clock.now();
  WorkClock::work(0.1);
  const Rendering late = GetParam()(session);
  EXPECT_LT(late.seconds, 1.05 * 0.3);
  EXPECT_LT(static_cast<double>(late.samples),
            0.9 * static_cast<double>(GetParam()(session_of(clock, TimeBudget{0.3})).samples));
}

TEST(TimeBudgetOfChains, GivesTheSeedPassItsShareAndKeepsTheEndBack) {
  const WorkClock clock;
  const Rendering r = by_chains(session_of(clock, TimeBudget{0.5}));
  EXPECT_NEAR(r.seed_seconds, 0.1, 0.005);
  // The end is made twice: once to know how long it takes.
  const double steps = (0.5 - 0.1 - 2 * the_end) / per_step;
  EXPECT_NEAR(static_cast<double>(r.samples), steps, 0.05 * steps);
}

// Nearly all of it is a seed pass, after which there is no time left to rehearse what comes at the end.
class LongSeedPass : public CountingRun {
 public:
  static constexpr double end = 0.04;

  // `said`: how long the end takes.
  explicit LongSeedPass(double said) : CountingRun(1, 40), said_(said) {}
  void seed(std::uint64_t of_each) override {
    CountingRun::seed(of_each);
    WorkClock::work(per_seed * static_cast<double>(slices * of_each));
  }
  void advance(std::uint64_t samples) override {
    CountingRun::advance(samples);
    WorkClock::work(per_step * static_cast<double>(samples));
  }
  Rendering findings() const override {
    WorkClock::work(end);
    return CountingRun::findings();
  }
  double seconds_of_findings() const override { return said_; }

 private:
  double said_;
};

TEST(TimeBudgetOfSeeds, LeavesWhatTheEndTakes) {
  const WorkClock clock;
  const auto seconds_of = [&](double said) {
    const Session session = session_of(clock, TimeBudget{0.6});
    wander::Run execution(session);
    LongSeedPass run(said);
    return drive(run, execution).seconds;
  };
  EXPECT_LT(seconds_of(LongSeedPass::end), 1.03 * 0.6);
  EXPECT_GT(seconds_of(LongSeedPass::end), 0.9 * 0.6);
  EXPECT_GT(seconds_of(0), 1.1 * 0.6) << "the wrong twin";
}

// ---- the number of chains

constexpr ChainSettings settings{.steps_per_chain = 100, .fewest_seeds = 4096};

int chains_of(const Budget& budget, const ChainSettings& given = settings) {
  const WorkClock clock;
  return by_chains(session_of(clock, budget), given).chains;
}

TEST(NumberOfChains, FollowsTheBudget) {
  EXPECT_EQ(chains_of(SampleBudget{6'400}), 64) << "one for each group, however short";
  EXPECT_EQ(chains_of(SampleBudget{12'800}), 128);
  EXPECT_EQ(chains_of(SampleBudget{19'199}), 128);
  EXPECT_EQ(chains_of(SampleBudget{200'000}), 256) << "no more than were asked for";
  EXPECT_EQ(chains_of(ErrorBudget{0.1}), 64) << "how many steps that takes is not known";
}

// 0.08 s for the chains, in which as many samples of the seed pass could be made, are 16000.
TEST(NumberOfChains, FollowsTheSpeedOfTheSeedPass) {
  EXPECT_EQ(chains_of(TimeBudget{0.1}), 128);
  EXPECT_EQ(chains_of(TimeBudget{0.02}), 64);
}

TEST(NumberOfChains, IsWhatWasAskedFor) {
  EXPECT_EQ(chains_of(SampleBudget{6'400}, {.steps_per_chain = 0, .fewest_seeds = 4096}), 256);
}

// Chains that are left out change nothing of the others: a trace shows chains of any run.
TEST(NumberOfChains, LeavesTheChainsThatRunAsTheyAre) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  const auto first_chain = [&](int chains) {
    PathGroup<Flat, Family> group(space, make_family({}, space.max_vertices()), 1, 3, 4);
    group.add_seeds(500);
    group.keep_chains(chains);
    group.start_chains(SeedTally(space.max_vertices()));
    group.advance(static_cast<std::uint64_t>(50 * chains));
    GroupsFilm film({scene->bins()});
    MutationStatistics statistics(Family::names, scene->bins(), scene->max_vertices());
    ChainDraws draws;
    group.deliver(film, statistics, draws);
    const Draws all = draws.of(1);
    return std::vector(all.chain(0), all.chain(0) + all.length);
  };
  EXPECT_EQ(first_chain(1), first_chain(4));
}

}  // namespace
}  // namespace wander::test
