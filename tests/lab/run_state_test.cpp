// The state of a run, saved at any place and loaded into a run that was just made, goes on with the
// same bits: every kind of run, in either precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>

#include "lab/drive.h"
#include "lab/run_state.h"
#include "lab/world_methods.h"
#include "records/run_json.h"
#include "tests/support/test_scenes.h"

namespace wander::test::run_state_test {
namespace {

using nlohmann::ordered_json;

struct Case {
  const char* method;
  StepEstimator estimator = StepEstimator::usual;
  FilmLayout film{};
  FilmParts parts = FilmParts::chains;
};
// As films of more than 2^14 bins are kept, with all that they may have.
constexpr FilmLayout large{.most_small = 4, .by_length = Keep::always, .maps = Keep::always};
std::string name_of_case(const Case& c) {
  std::string name = c.method;
  std::ranges::replace(name, '-', '_');
  if (c.film == large) name += "_large";
  if (c.parts == FilmParts::pooled) name += "_pooled";
  return name + (c.estimator == StepEstimator::usual     ? ""
                 : c.estimator == StepEstimator::kelemen ? "_kelemen"
                                                         : "_expected");
}

Session session_of(int threads) {
  Session session;
  session.budget = SampleBudget{100'000};
  session.threads = threads;
  return session;
}

// A run with all that it needs.
template <World W>
struct Made {
  Made(const Case& c, int threads)
      : dials{.estimator = c.estimator,
              .chains = {.film_parts = c.parts, .fewest_seeds = 4096},
              .film = c.film},
        session(session_of(threads)),
        job(mirror_and_glass(), find_method(c.method), dials),
        run(methods.make()) {}

  Dials dials;
  Session session;
  Job job;
  Run execution{session};
  WorldMethods<W> methods{job, execution};
  std::unique_ptr<LiveRun> run;
};

constexpr std::uint64_t all_seeds = 64;  // of each slice
constexpr int chains = 3;

// The run after so many seeds of each slice and so many samples.
void go_on(LiveRun& run, std::uint64_t seeds, std::uint64_t samples) {
  if (run.takes_seeds()) {
    run.seed(seeds - run.seeds().of_each());
    if (seeds == all_seeds && samples > 0) run.start(chains);
  }
  if (samples > run.samples()) run.advance(samples - run.samples());
}

// Every number of run.json but times.
ordered_json numbers_of(const Rendering& rendering) {
  ordered_json json = to_json(RunRecord{rendering, {}});
  for (const char* time : {"threads", "seconds", "cpu_seconds", "seed_seconds", "command_line"})
    json.erase(time);
  if (json.contains("chains")) json["chains"].erase("ess_per_second");
  if (json.contains("mutations"))
    for (auto& [name, mutation] : json["mutations"].items()) mutation.erase("seconds");
  return json;
}
void expect_same(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(ordered_json::diff(numbers_of(a), numbers_of(b)), ordered_json::array());
}

constexpr std::uint64_t last = 6'011;

struct Place {
  std::uint64_t seeds, samples;
};
constexpr Place places[] = {
    {0, 0},           {1, 0},          {37, 0},           {all_seeds, 0},
    {all_seeds, 1},   {all_seeds, 67}, {all_seeds, 4096}, {all_seeds, 5'555},
    {all_seeds, last}};
// Where a run stops is the same text in all precisions; what it has kept is not.
constexpr Place places_in_float[] = {{37, 0}, {all_seeds, 67}};

template <World W>
void expect_round_trips(const Case& c, std::span<const Place> of) {
  for (const Place place : of) {
    SCOPED_TRACE(std::to_string(place.seeds) + " seeds, " + std::to_string(place.samples) +
                 " samples");
    Made<W> first(c, 2), second(c, 3);
    go_on(*first.run, place.seeds, place.samples);
    const std::string state = state_of(*first.run);
    restore(*second.run, state);
    EXPECT_EQ(state_of(*second.run), state);
    EXPECT_EQ(second.run->samples(), place.samples);
    go_on(*second.run, all_seeds, last);
    go_on(*first.run, all_seeds, last);
    expect_same(second.run->findings(), first.run->findings());
    EXPECT_EQ(second.run->preview().value, first.run->preview().value);
  }
}

class RunState : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Methods, RunState,
    ::testing::Values(Case{"pt"}, Case{"lt"}, Case{"bdpt"}, Case{"pt-naive"}, Case{"lt-naive"},
                      Case{"mlt"}, Case{"pssmlt"}, Case{"pssmlt", StepEstimator::expected},
                      Case{"mmlt"}, Case{"mmlt", StepEstimator::kelemen},
                      Case{"bdpt", StepEstimator::usual, large},
                      Case{"mmlt", StepEstimator::usual, large},
                      Case{"mlt", StepEstimator::usual, {}, FilmParts::pooled},
                      Case{"mmlt", StepEstimator::usual, {}, FilmParts::pooled},
                      Case{"pssmlt", StepEstimator::usual, large, FilmParts::pooled},
                      Case{"mlt", StepEstimator::usual, large, FilmParts::pooled}),
    [](const auto& info) { return name_of_case(info.param); });

TEST_P(RunState, GoesOnWithTheSameBits) { expect_round_trips<Flatland>(GetParam(), places); }
TEST_P(RunState, GoesOnWithTheSameBitsInFloat) {
  expect_round_trips<FlatlandSingle>(GetParam(), places_in_float);
}

// The wrong twin: a state that is not the one asked for is seen.
TEST_P(RunState, OfAnotherPlaceIsAnother) {
  Made<Flatland> first(GetParam(), 2), second(GetParam(), 2);
  go_on(*first.run, all_seeds, 4096);
  go_on(*second.run, all_seeds, 4097);
  EXPECT_NE(state_of(*first.run), state_of(*second.run));
  EXPECT_NE(first.run->findings().film.value, second.run->findings().film.value);
}

TEST_P(RunState, ThatIsCutShortOrTooLongIsRefused) {
  Made<Flatland> first(GetParam(), 2), second(GetParam(), 2);
  go_on(*first.run, all_seeds, 4096);
  const std::string state = state_of(*first.run);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{3}, state.size() / 2, state.size() - 1})
    EXPECT_ANY_THROW(restore(*second.run, state.substr(0, size))) << size;
  EXPECT_ANY_THROW(restore(*second.run, state + "x"));
}

// ---- budgets

std::string bytes_of(const StateWriter& state) {
  std::ostringstream bytes;
  state(bytes);
  return std::move(bytes).str();
}

// Kept every time it can be, a run to a budget can be carried on from any of these places.
template <class MakeRun>
void expect_carried_on(const Budget& budget, MakeRun&& make) {
  Session session = session_of(2);
  session.budget = budget;
  std::vector<KeptRun> kept;
  const Keeper keeper{[&](const Headway& headway, const StateWriter& state) {
                        kept.push_back({headway, bytes_of(state)});
                      },
                      1e-9, 1e-9};
  Run execution(session);
  const auto made = make(execution);
  const Rendering whole = drive(*made->run, execution, {}, keeper);
  EXPECT_TRUE(whole.complete);
  ASSERT_GT(kept.size(), 1u);
  for (std::size_t i = 0; i < kept.size(); i += 1 + kept.size() / 2) {
    SCOPED_TRACE("kept after " + std::to_string(kept[i].headway.samples) + " samples");
    Session other = session;
    other.threads = 1;
    Run later(other);
    const auto again = make(later);
    restore(*again->run, kept[i].state);
    expect_same(drive(*again->run, later, kept[i].headway), whole);
  }
}

struct InWorld {
  InWorld(const char* method, const Run& execution)
      : job(mirror_and_glass(), find_method(method)),
        methods(job, execution),
        run(methods.make()) {}
  Job job;
  WorldMethods<Flatland> methods;
  std::unique_ptr<LiveRun> run;
};

TEST(CarriedOn, ToTheSameSamplesOrErrorHasTheSameBits) {
  for (const char* method : {"bdpt", "mlt"})
    for (const Budget& budget : {Budget{SampleBudget{20'001}}, Budget{ErrorBudget{0.12}}}) {
      SCOPED_TRACE(method);
      expect_carried_on(budget, [&](const wander::Run& execution) {
        return std::make_unique<InWorld>(method, execution);
      });
    }
}

// An interruption in the seed pass shows what was found, and is carried on from where it was.
TEST(CarriedOn, AnInterruptedSeedPassLosesNothing) {
  Session session = session_of(2);
  wander::Run straight(session);
  const InWorld whole("mlt", straight);
  const Rendering expected = drive(*whole.run, straight);
  std::atomic<bool> interrupted = false;
  std::vector<KeptRun> kept;
  session.interrupted = &interrupted;
  const Keeper keeper{[&](const Headway& headway, const StateWriter& state) {
                        kept.push_back({headway, bytes_of(state)});
                        interrupted = true;
                      },
                      1e-9, 1e-9};
  wander::Run stopped(session);
  const InWorld cut("mlt", stopped);
  EXPECT_FALSE(drive(*cut.run, stopped, {}, keeper).complete);
  EXPECT_EQ(kept.back().headway.samples, 0u);
  session.interrupted = nullptr;
  wander::Run later(session);
  const InWorld again("mlt", later);
  restore(*again.run, kept.back().state);
  expect_same(drive(*again.run, later, kept.back().headway), expected);
}

// Though the chains that show it make all samples of a small budget before they look up.
TEST(CarriedOn, AnInterruptedSeedPassIsNotComplete) {
  Session session = session_of(2);
  session.budget = SampleBudget{640};
  std::atomic<bool> interrupted = false;
  session.interrupted = &interrupted;
  const Keeper keeper{[&](const Headway&, const StateWriter&) { interrupted = true; }, 1e-9, 1e-9};
  wander::Run stopped(session);
  const InWorld cut("mlt", stopped);
  const Rendering shown = drive(*cut.run, stopped, {}, keeper);
  EXPECT_EQ(shown.samples, 640U);
  EXPECT_FALSE(shown.complete);
}

// A run is the same however far it was sent first.
TEST(CarriedOn, IndependentSamplesToALargerBudgetAreThoseOfOneRun) {
  Session session = session_of(2);
  const auto to = [&](InWorld& made, wander::Run& execution) {
    return drive(*made.run, execution);
  };
  session.budget = SampleBudget{30'001};
  wander::Run direct(session);
  InWorld one("bdpt", direct);
  const Rendering expected = to(one, direct);
  session.budget = SampleBudget{10'003};
  wander::Run first(session);
  InWorld short_run("bdpt", first);
  to(short_run, first);
  session.budget = SampleBudget{30'001};
  wander::Run second(session);
  InWorld longer("bdpt", second);
  restore(*longer.run, state_of(*short_run.run));
  expect_same(to(longer, second), expected);
}

}  // namespace
}  // namespace wander::test::run_state_test
