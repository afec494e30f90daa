// What is recorded of chains is what render() runs, and every number of it fits the others.
#include "lab/trace.h"

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>

#include "lab/render.h"
#include "lab/replay.h"
#include "mutations/catalogue.h"
#include "tests/support/test_scenes.h"

namespace wander::test::trace_test {
namespace {

using Flat = Transport<Flatland>;

constexpr ChainSettings settings{.fewest_seeds = 4096};

Session session_of(int threads, std::uint64_t seed = 1) {
  Session session;
  session.threads = threads;
  session.seed = seed;
  return session;
}

struct Room {
  explicit Room(const description::Scene& description) : scene(build(description)) {}
  FlatScene scene;
  Flat space{*scene, Roulette::off};
  Family family = make_family({}, scene->max_vertices());

  Trace trace(int chains, TraceWindow window, const Session& session) const {
    return Tracer(space, family, session, {chains, window}, settings).run();
  }
  Trajectory trajectory(int chains, TraceWindow window, std::uint64_t seed = 1) const {
    return trace(chains, window, session_of(2, seed)).trajectory;
  }
};

// Equal bit for bit, so that NaN equals NaN.
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, {}, std::bit_cast<std::uint64_t, double>,
                            std::bit_cast<std::uint64_t, double>);
}
bool same(const RecordedPaths& a, const RecordedPaths& b) {
  return same(a.position, b.position) && same(a.film, b.film) && a.vertices == b.vertices &&
         a.path_class == b.path_class;
}
bool same(const Trajectory& a, const Trajectory& b) {
  return a.draws == b.draws && a.max_vertices == b.max_vertices && a.classes == b.classes &&
         same(a.state, b.state) && same(a.proposed, b.proposed) && a.mutation == b.mutation &&
         a.reason == b.reason && a.accepted == b.accepted && same(a.acceptance, b.acceptance) &&
         same(a.log_f, b.log_f) && same(a.log_f_current, b.log_f_current) &&
         same(a.log_f_proposed, b.log_f_proposed) && same(a.log_forward, b.log_forward) &&
         same(a.log_reverse, b.log_reverse) && same(a.start, b.start) &&
         same(a.attempts.position, b.attempts.position) &&
         same(a.attempts.failure, b.attempts.failure);
}

class TracedRooms : public ::testing::TestWithParam<int> {
 protected:
  Room room_{lit_scenes()[static_cast<std::size_t>(GetParam())].scene};
};
INSTANTIATE_TEST_SUITE_P(Rooms, TracedRooms,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

// All chains of a render, and as many steps.
MutationRecord total_of(const Trajectory& t, std::size_t mutation) {
  MutationRecord record;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (static_cast<std::size_t>(t.mutation[i]) != mutation) continue;
    ++record.proposed;
    record.accepted += t.accepted[i];
    record.mean_acceptance += t.acceptance[i];
    if (!t.accepted[i]) ++record.failures[t.reasons[static_cast<std::size_t>(t.reason[i])]];
  }
  if (record.proposed > 0) record.mean_acceptance /= static_cast<double>(record.proposed);
  return record;
}
// A mutation that never acted has no record.
MutationRecord record_of(const Rendering& rendering, std::string_view name) {
  const auto found = std::ranges::find(rendering.mutations, name, &MutationRecord::name);
  return found == rendering.mutations.end() ? MutationRecord{} : *found;
}

TEST(TracedChains, AreTheChainsOfRender) {
  const Room room(diffuse_room());
  constexpr int chains = settings.groups * settings.chains_per_group;
  constexpr std::uint64_t steps = 60;
  Session session = session_of(2);
  session.budget = SampleBudget{chains * steps};
  const ChainSettings light{
      .steps_per_chain = 0, .seed_share = 0, .fewest_seeds = settings.fewest_seeds};
  const Rendering rendering = ChainRenderer(room.space, room.family, session, light).render("mlt");
  const Trace trace = room.trace(chains, {.end = steps}, session);
  const Trajectory other = room.trajectory(chains, {.end = steps}, 2);
  ASSERT_GE(rendering.mutations.size(), 3u);
  int differences = 0;  // of chains with another seed: the control
  for (std::size_t m = 0; m < Family::count; ++m) {
    const MutationRecord expected = record_of(rendering, trace.trajectory.mutations[m]);
    const MutationRecord traced = total_of(trace.trajectory, m);
    EXPECT_EQ(expected.proposed, traced.proposed);
    EXPECT_EQ(expected.accepted, traced.accepted);
    EXPECT_EQ(expected.failures, traced.failures);
    EXPECT_NEAR(expected.mean_acceptance, traced.mean_acceptance, 1e-12);
    differences += total_of(other, m).failures != expected.failures ? 1 : 0;
  }
  EXPECT_GT(differences, 0);
  const Estimate& seed_pass = rendering.normalization->estimates.at("seed_pass");
  EXPECT_EQ(seed_pass.value, trace.normalization.value);
  EXPECT_EQ(seed_pass.standard_error, trace.normalization.standard_error);
}

TEST_P(TracedRooms, HoldEveryTermOfTheAcceptance) {
  const Trajectory t = room_.trajectory(3, {.end = 1000});
  ASSERT_EQ(t.size(), 3000u);
  int proposals = 0, accepted = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double log_ratio =
        t.log_f_proposed[i] + t.log_reverse[i] - t.log_f_current[i] - t.log_forward[i];
    if (t.proposed.vertices[i] == 0) {
      EXPECT_TRUE(std::isnan(log_ratio));
      EXPECT_EQ(t.acceptance[i], 0);
      EXPECT_EQ(t.proposed.path_class[i], -1);
      EXPECT_FALSE(t.accepted[i]);
      continue;
    }
    ++proposals;
    accepted += t.accepted[i];
    EXPECT_NEAR(std::min(1.0, std::exp(log_ratio)), t.acceptance[i], 1e-9);
  }
  EXPECT_GT(proposals, 300);
  EXPECT_GT(accepted, 100);
}

void expect_whole_path(const Trajectory& t, const RecordedPaths& paths, std::size_t i) {
  const auto axes = static_cast<std::size_t>(t.dimension);
  const auto longest = static_cast<std::size_t>(t.max_vertices);
  const auto vertices = static_cast<std::size_t>(paths.vertices[i]);
  for (std::size_t k = 0; k < longest * axes; ++k)
    ASSERT_EQ(std::isfinite(paths.position[i * longest * axes + k]), k < vertices * axes);
  ASSERT_GE(paths.film[i], 0);
  ASSERT_LE(paths.film[i], 1);
  ASSERT_EQ(t.classes.at(static_cast<std::size_t>(paths.path_class[i])).size(), vertices);
}

// A step leads from the state before it to its proposal, or stays.
TEST_P(TracedRooms, HoldStatesThatFollowFromOneAnother) {
  const Trajectory t = room_.trajectory(2, {.end = 1000});
  const auto draws = static_cast<std::size_t>(t.draws);
  const auto row = static_cast<std::size_t>(t.max_vertices * t.dimension);
  for (std::size_t i = 0; i < t.size(); ++i) {
    expect_whole_path(t, t.state, i);
    if (t.proposed.vertices[i] > 0) expect_whole_path(t, t.proposed, i);
    if (i % draws == 0) continue;
    ASSERT_EQ(t.log_f_current[i], t.log_f[i - 1]);
    const bool moved = t.accepted[i] != 0;
    const RecordedPaths& source = moved ? t.proposed : t.state;
    const std::size_t from = moved ? i : i - 1;
    ASSERT_EQ(t.state.vertices[i], source.vertices[from]);
    ASSERT_EQ(t.state.film[i], source.film[from]);
    ASSERT_EQ(t.state.path_class[i], source.path_class[from]);
    for (std::size_t k = 0; k < row; ++k)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(t.state.position[i * row + k]),
                std::bit_cast<std::uint64_t>(source.position[from * row + k]));
  }
}

TEST_P(TracedRooms, AreTheSameForAnyNumberOfThreads) {
  Session session = session_of(1);
  const Trajectory one = room_.trace(5, {.end = 300}, session).trajectory;
  for (const int threads : {2, 7}) {
    session.threads = threads;
    EXPECT_TRUE(same(one, room_.trace(5, {.end = 300}, session).trajectory));
  }
  session.seed = 2;
  EXPECT_FALSE(same(one, room_.trace(5, {.end = 300}, session).trajectory));
}

TEST_P(TracedRooms, AWindowHoldsTheStepsOfTheWholeChain) {
  const Trajectory whole = room_.trajectory(2, {.end = 1500});
  const Trajectory part = room_.trajectory(2, {.first = 1001, .end = 1500, .every = 7});
  ASSERT_EQ(part.draws, 72);
  EXPECT_EQ(part.first_step, 1001u);
  EXPECT_EQ(part.every, 7u);
  for (std::size_t chain = 0; chain < 2; ++chain)
    for (std::size_t d = 0; d < 72; ++d) {
      const std::size_t i = chain * 72 + d, j = chain * 1500 + 1001 + 7 * d;
      ASSERT_EQ(part.log_f[i], whole.log_f[j]);
      ASSERT_EQ(part.log_f_current[i], whole.log_f_current[j]);
      ASSERT_EQ(part.mutation[i], whole.mutation[j]);
      ASSERT_EQ(part.reason[i], whole.reason[j]);
      ASSERT_EQ(part.state.film[i], whole.state.film[j]);
      ASSERT_EQ(part.classes.at(static_cast<std::size_t>(part.state.path_class[i])),
                whole.classes.at(static_cast<std::size_t>(whole.state.path_class[j])));
    }
}

TEST(TraceWindows, CountTheirDraws) {
  EXPECT_EQ((TraceWindow{0, 1000, 1}.draws()), 1000u);
  EXPECT_EQ((TraceWindow{3, 10, 4}.draws()), 2u);
  EXPECT_EQ((TraceWindow{3, 4, 100}.draws()), 1u);
  for (const TraceWindow window : {TraceWindow{5, 23, 3}, TraceWindow{0, 7, 7}}) {
    std::uint64_t held = 0;
    for (std::uint64_t i = 0; i < 40; ++i) held += window.holds(i) ? 1 : 0;
    EXPECT_EQ(held, window.draws());
  }
}

TEST_P(TracedRooms, AReplayedStepIsTheRecordedOne) {
  const Trajectory t = room_.trajectory(3, {.end = 200});
  int proposals = 0;
  for (const auto& [chain, step] : {std::pair{0, 0}, {2, 199}, {1, 57}, {1, 58}, {1, 59}, {2, 3}}) {
    const auto i = static_cast<std::size_t>(chain * t.draws + step);
    const Replay r = replay(room_.space, room_.family, session_of(2), chain,
                            static_cast<std::uint64_t>(step), settings);
    EXPECT_EQ(r.mutation, t.mutations.at(static_cast<std::size_t>(t.mutation[i])));
    EXPECT_EQ(name_of(r.reason), t.reasons.at(static_cast<std::size_t>(t.reason[i])));
    EXPECT_EQ(r.acceptance, t.acceptance[i]);
    EXPECT_EQ(r.x.f.log(), t.log_f_current[i]);
    ASSERT_EQ(r.proposal.has_value(), t.proposed.vertices[i] > 0);
    if (!r.proposal) continue;
    ++proposals;
    EXPECT_EQ(r.proposal->y.f.log(), t.log_f_proposed[i]);
    EXPECT_EQ(r.proposal->forward.log(), t.log_forward[i]);
    EXPECT_EQ(r.proposal->reverse.log(), t.log_reverse[i]);
    EXPECT_EQ(r.proposal->decider < r.acceptance, t.accepted[i] != 0);
    EXPECT_EQ(r.proposal->y.film[0], t.proposed.film[i]);
  }
  EXPECT_GT(proposals, 0);
}

// Of what is refused, too, and has as many vertices as the state.
TEST_P(TracedRooms, TellTheClassOfWhatWasProposed) {
  const Trajectory t = room_.trajectory(1, {.end = 2000});
  int told = 0;
  for (std::size_t i = 0; i < t.size() && told < 40; ++i) {
    if (t.accepted[i] || t.proposed.vertices[i] != t.state.vertices[i] ||
        t.proposed.vertices[i] == 0)
      continue;
    ++told;
    const Replay r = replay(room_.space, room_.family, session_of(2), 0, i, settings);
    EXPECT_EQ(t.classes.at(static_cast<std::size_t>(t.proposed.path_class[i])),
              r.proposal->y.path_class);
    EXPECT_EQ(t.classes.at(static_cast<std::size_t>(t.state.path_class[i])), r.x.path_class);
  }
  EXPECT_GT(told, 5);
}

// The state before the first draw is recorded too, also where the first draw moves.
TEST_P(TracedRooms, HoldWhereTheyStart) {
  const Trajectory t = room_.trajectory(3, {.first = 40, .end = 60});
  const auto row = static_cast<std::size_t>(t.max_vertices * t.dimension);
  ASSERT_EQ(t.start.vertices.size(), 3u);
  for (int chain = 0; chain < 3; ++chain) {
    const auto c = static_cast<std::size_t>(chain);
    const Replay r = replay(room_.space, room_.family, session_of(2), chain, 40, settings);
    ASSERT_EQ(t.start.vertices[c], static_cast<int>(r.x.vertices.size()));
    EXPECT_EQ(t.classes.at(static_cast<std::size_t>(t.start.path_class[c])), r.x.path_class);
    EXPECT_EQ(t.start.film[c], r.x.film[0]);
    for (std::size_t k = 0; k < r.x.vertices.size(); ++k)
      EXPECT_EQ(t.start.position[c * row + 2 * k], r.x.vertices[k].position[0]);
  }
}

using Point = Vec<2, double>;

// Lines that a failed proposal left, and where it failed.
struct Failed {
  std::vector<std::vector<Point>> lines;
  Point place;

  Failed(const Trajectory& t, std::size_t i)
      : place(t.attempts.failure[2 * i], t.attempts.failure[2 * i + 1]) {
    const auto points = static_cast<std::size_t>(t.attempts.max_points);
    bool goes_on = false;
    for (std::size_t k = i * points; k < (i + 1) * points; ++k) {
      const Point p(t.attempts.position[2 * k], t.attempts.position[2 * k + 1]);
      if (std::isfinite(p.x) && !goes_on) lines.emplace_back();
      if (std::isfinite(p.x)) lines.back().push_back(p);
      goes_on = std::isfinite(p.x);
    }
  }
};

// What blocks a connection lies on it; a ray that meets nothing leaves the scene; and where there
// is a proposal there is no failure.
TEST_P(TracedRooms, HoldWhatFailedAsFarAsItCame) {
  const Trajectory t = room_.trajectory(3, {.end = 1000});
  int occluded = 0, missed = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const Failed failed(t, i);
    const std::string& reason = t.reasons[static_cast<std::size_t>(t.reason[i])];
    if (t.proposed.vertices[i] > 0) {
      EXPECT_TRUE(failed.lines.empty());
      EXPECT_TRUE(std::isnan(failed.place.x));
      continue;
    }
    for (const auto& line : failed.lines) EXPECT_GE(line.size(), 1u);
    if (reason == "occluded") {
      ++occluded;
      ASSERT_FALSE(failed.lines.empty());
      ASSERT_EQ(failed.lines.back().size(), 2u);
      const Point a = failed.lines.back()[0], b = failed.lines.back()[1];
      EXPECT_NEAR(glm::distance(a, failed.place) + glm::distance(failed.place, b),
                  glm::distance(a, b), 1e-9);
    }
    if (reason == "missed_scene") {
      ++missed;
      ASSERT_FALSE(failed.lines.empty());
      EXPECT_EQ(failed.lines.back().back(), failed.place);
    }
  }
  EXPECT_GT(occluded + missed, 20);
}

// The factors that a replay names multiply to what it says of the path.
TEST_P(TracedRooms, TheFactorsOfAReplayedPathMakeItsContribution) {
  const Replay r = replay(room_.space, room_.family, session_of(2), 0, 20, settings);
  double f = 1;
  for (std::size_t i = 0; i < r.x.vertices.size(); ++i) {
    f *= r.x.vertices[i].value;
    if (i + 1 < r.x.vertices.size()) f *= r.x.vertices[i].geometry;
  }
  EXPECT_NEAR(f, r.x.f.value(), 1e-12 * f);
}

TEST(StepLogs, NeverGrowDuringSteps) {
  const Room room(mirror_and_glass());
  Session session;
  wander::Run run(session);
  const ShownChains<Flat, PathChains<Flat, Family>> shown(room.space, room.family, run, settings);
  auto chain = shown.chain(0);
  StepLog log;
  log.reserve(2000, room.space.max_vertices(), 2);
  const auto* steps = log.steps().data();
  const auto* positions = log.positions().data();
  const auto* events = log.events().data();
  for (int i = 0; i < 2000; ++i)
    chain.step([&](const Step<Flatland>& step) { log.add(room.space, step); });
  EXPECT_EQ(log.steps().size(), 2000u);
  EXPECT_EQ(log.steps().data(), steps);
  EXPECT_EQ(log.positions().data(), positions);
  EXPECT_EQ(log.events().data(), events);
}

TEST(TraceFailures, SayWhatIsMissing) {
  const Room dark(dark_room());
  EXPECT_THROW(dark.trajectory(1, {}), NoLightFound);
  const Room room(diffuse_room());
  EXPECT_THROW(room.trajectory(settings.groups * settings.chains_per_group + 1, {}),
               std::runtime_error);
  const std::atomic<bool> interrupted = true;
  Session session = session_of(2);
  session.interrupted = &interrupted;
  EXPECT_THROW(room.trace(1, {}, session), NothingComputed);
}

// An interruption that comes while chains run leaves as many draws of every chain.
TEST(TraceFailures, AnInterruptedTraceIsCutToEqualLength) {
  const Room room(diffuse_room());
  std::atomic<bool> interrupted = false;
  Session session = session_of(2);
  session.interrupted = &interrupted;
  session.report = [&](const ProgressReport& progress) {
    if (std::string_view(progress.phase) == "sampling") interrupted = true;
  };
  const Trace trace = room.trace(3, {.end = 1'000'000'000}, session);
  EXPECT_FALSE(trace.complete);
  EXPECT_GT(trace.trajectory.draws, 0);
  EXPECT_EQ(trace.trajectory.log_f.size(), trace.trajectory.size());
}

}  // namespace
}  // namespace wander::test::trace_test
