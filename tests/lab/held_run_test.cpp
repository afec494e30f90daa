// A run that is held goes on as often as it is asked, with the bits of one that was never stopped:
// wherever it was interrupted, also in its seed pass, and also from where it was kept.
#include "lab/held_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string_view>

#include "lab/engine.h"
#include "mlt/seeds/nothing_found.h"
#include "tests/support/test_scenes.h"

namespace wander::test::held_run_test {
namespace {

// Moves on by a second whenever it is looked at, so that every report is made.
class RestlessClock : public Clock {
 public:
  Moment now() const override {
    const double seconds = ++looks_;
    return {seconds, seconds};
  }

 private:
  mutable std::atomic<int> looks_ = 0;
};

class HeldRuns : public testing::TestWithParam<const char*> {
 protected:
  Job job() const {
    return {mirror_and_glass(), find_method(GetParam()), {.chains = {.fewest_seeds = 8192}}};
  }
  Session session(std::uint64_t samples = 100'000) {
    Session session;
    session.budget = SampleBudget{samples};
    session.threads = 2;
    session.interrupted = &interrupted_;
    session.clock = &clock_;
    return session;
  }
  // Interrupts itself at the first report of the phase.
  Session stopping_in(std::string_view phase) {
    Session stopping = session();
    stopping.report = [this, phase](const ProgressReport& report) {
      if (report.phase == phase) interrupted_ = true;
    };
    return stopping;
  }
  Rendering go_on(HeldRun& run, const Session& session) {
    interrupted_ = false;
    Rendering rendering = run.go_on(session);
    interrupted_ = false;
    return rendering;
  }
  void expect_same(const Rendering& a, const Rendering& b) {
    EXPECT_TRUE(a.complete && b.complete);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(a.film.value, b.film.value);
    EXPECT_EQ(a.film.reliable, b.film.reliable);
    if (a.normalization) {
      EXPECT_EQ(a.normalization->value, b.normalization->value);
    }
  }

  std::atomic<bool> interrupted_ = false;
  RestlessClock clock_;
};

TEST_P(HeldRuns, GoOnAfterAnInterruption) {
  const Rendering whole = render(job(), session());
  for (const char* phase : {"seed pass", "sampling"}) {
    HeldRun run(job(), session());
    const Rendering part = go_on(run, stopping_in(phase));
    const bool has_seeds = job().method().is_markov_chain();
    EXPECT_EQ(part.complete, phase == std::string_view("seed pass") && !has_seeds) << phase;
    expect_same(go_on(run, session()), whole);
  }
}

TEST_P(HeldRuns, AreKeptAsTheyWereLeft) {
  const Rendering whole = render(job(), session());
  for (const char* phase : {"seed pass", "sampling"}) {
    HeldRun run(job(), session());
    go_on(run, stopping_in(phase));
    HeldRun another(job(), session(), run.kept());
    expect_same(go_on(another, session()), whole);
  }
}

TEST_P(HeldRuns, TakeALargerBudgetAsACarriedOnRunDoes) {
  HeldRun run(job(), session(50'000));
  go_on(run, session(50'000));
  const KeptRun kept = run.kept();
  expect_same(go_on(run, session()), carry_on(kept, job(), session(), {}));
}

// Where another stays until then, which is not lost to the beginning of this.
TEST_P(HeldRuns, AreKeptOnceTheyAreWorthTheirPlace) {
  int kept = 0;
  Keeper keeper{.keep = [&](const Headway&, const StateWriter&) { ++kept; }, .every = 1e-9};
  const bool has_seeds = job().method().is_markov_chain();
  for (const char* phase : {"seed pass", "sampling"}) {
    if (phase == std::string_view("seed pass") && !has_seeds) continue;
    SCOPED_TRACE(phase);
    // What an interrupted seed pass would show is more than 50 000 steps, and no reason to keep it.
    keeper.least = phase == std::string_view("seed pass") ? 50'000 : 99'000;
    HeldRun run(job(), session());
    interrupted_ = false;
    try {
      run.go_on(stopping_in(phase), keeper);
      ADD_FAILURE() << "it went on";
    } catch (const NothingComputed& problem) {
      EXPECT_EQ(problem.what(),
                fmt::format("interrupted before there were as many samples as the {} of the film "
                            "in its place, which stays as it is",
                            keeper.least));
    }
    EXPECT_EQ(kept, 0);
  }
  interrupted_ = false;
  keeper.least = 1'000'000;  // but this one comes to its end
  EXPECT_TRUE(HeldRun(job(), session()).go_on(session(), keeper).complete);
  EXPECT_EQ(kept, 1);
  kept = 0;
  keeper.least = 1;
  EXPECT_FALSE(HeldRun(job(), session()).go_on(stopping_in("sampling"), keeper).complete);
  EXPECT_GT(kept, 0);
}

INSTANTIATE_TEST_SUITE_P(Methods, HeldRuns, testing::Values("bdpt", "mlt", "pssmlt", "mmlt"),
                         [](const auto& each) { return std::string(each.param); });

// What was spent counts, the time between does not.
TEST(HeldRunTimes, AreThoseOfTheRun) {
  class Hand : public Clock {
   public:
    Moment now() const override { return {seconds, seconds}; }
    double seconds = 0;
  } clock;
  const Job job(mirror_and_glass(), find_method("bdpt"));
  Session session;
  session.budget = SampleBudget{1000};
  session.clock = &clock;
  HeldRun run(job, session);
  clock.seconds = 5;  // to build it
  EXPECT_EQ(run.go_on(session).seconds, 5);
  clock.seconds = 100;
  EXPECT_EQ(run.go_on(session).seconds, 5);
}

}  // namespace
}  // namespace wander::test::held_run_test
