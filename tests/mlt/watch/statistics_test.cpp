// The statistics of mutations against a recount of the same steps, and the numbers of classes.
#include "mlt/watch/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "mutations/catalogue.h"
#include "tests/support/invariance.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// ---- classes as numbers

Path<W> path_of(const std::string& letters) {
  Path<W> x(static_cast<int>(letters.size()));
  x.resize(static_cast<int>(letters.size()));
  for (int i = 0; i < x.size(); ++i)
    x[i].event =
        letters[static_cast<std::size_t>(i)] == 'S' ? Event::transmission : Event::scattering;
  x[0].event = Event::emission;
  x[x.size() - 1].event = Event::detection;
  return x;
}

TEST(Features, OfNothingAreDark) {
  EXPECT_TRUE(Features{}.is_dark());
  EXPECT_FALSE((Features{.vertices = 2}).is_dark());
}

TEST(Features, ThatAreApartOnBothAxesOfAnImageJumpByBoth) {
  EXPECT_DOUBLE_EQ(squared_jump({.film = {0.1, 0.2}}, {.film = {0.4, 0.6}}), 0.25);
  EXPECT_DOUBLE_EQ(squared_jump({.film = {0.5, 0.9}}, {.film = {0.5, 0.4}}), 0.25);
}

TEST(PathClass, IsANumberThatNamesItself) {
  const std::string longest = "L" + std::string(31, 'S') + std::string(32, 'D') + "E";
  for (const std::string& letters :
       {std::string("LE"), std::string("LDE"), std::string("LSE"), std::string("LDSE"),
        std::string("LSDE"), std::string("LDDE"), longest}) {
    EXPECT_EQ(name_of_class(path_class_of(path_of(letters))), letters);
    EXPECT_EQ(path_class(path_of(letters)), letters);
  }
  EXPECT_EQ(path_class_of(path_of("LDSE")), 0b101u);
  EXPECT_EQ(path_class_of(path_of("LS" + longest.substr(1))), other_class);
  EXPECT_EQ(name_of_class(other_class), "other");
}

TEST(ClassTable, KeepsTheFirstClassesAndCountsTheRestTogether) {
  ClassTable table;
  EXPECT_EQ(table.index(other_class), 0u);
  for (PathClass code = 1; code <= 1000; ++code)
    EXPECT_EQ(table.index(code), code <= ClassTable::most_classes ? code : 0u);
  for (PathClass code = 1; code <= ClassTable::most_classes; ++code) {
    EXPECT_EQ(table.index(code), code);
    EXPECT_EQ(table.code(code), code);
  }
  EXPECT_EQ(table.size(), ClassTable::most_classes + 1);
}

// ---- the counts

struct Recount {
  std::uint64_t proposed = 0, accepted = 0;
  double acceptance = 0;
  std::map<std::string, std::uint64_t> failures{};

  void add(const Step<W>& step) {
    ++proposed;
    acceptance += step.acceptance;
    if (step.accepted()) {
      ++accepted;
    } else {
      ++failures[std::string(name_of(step.reason))];
    }
  }
};

template <class Record>
void expect_equal(const Record& record, const Recount& recount) {
  EXPECT_EQ(record.proposed, recount.proposed);
  EXPECT_EQ(record.accepted, recount.accepted);
  EXPECT_EQ(record.failures, recount.failures);
  EXPECT_NEAR(record.mean_acceptance, recount.acceptance / static_cast<double>(recount.proposed),
              1e-12);
}

struct Recounts {
  Recount all;
  std::map<int, Recount> by_length{};
  std::map<std::string, Recount> by_class{};
  double squared_jump = 0;
  std::uint64_t run = 0, longest_run = 0;

  void add(const Flat& space, const Step<W>& step) {
    all.add(step);
    by_length[step.current.size()].add(step);
    by_class[path_class(step.current)].add(step);
    if (step.acceptance > 0) {
      const double jump =
          space.film_position(step.proposed)[0] - space.film_position(step.current)[0];
      squared_jump += step.acceptance * jump * jump;
    }
    run = step.accepted() ? 0 : run + 1;
    longest_run = std::max(longest_run, run);
  }
};

void expect_equal(const MutationRecord& record, const Recounts& recounts) {
  expect_equal(record, recounts.all);
  ASSERT_EQ(record.by_length.size(), recounts.by_length.size());
  for (const PathsRecord& part : record.by_length)
    expect_equal(part, recounts.by_length.at(part.vertices));
  ASSERT_EQ(record.by_class.size(), recounts.by_class.size());
  for (const PathsRecord& part : record.by_class)
    expect_equal(part, recounts.by_class.at(part.path_class));
  EXPECT_NEAR(record.squared_jump,
              recounts.squared_jump / static_cast<double>(recounts.all.proposed), 1e-12);
  EXPECT_EQ(record.longest_rejection_run, recounts.longest_run);
  // One step in some is measured; of a mutation that acts rarely it may be none.
  EXPECT_TRUE(record.seconds > 0 || (std::isnan(record.seconds) && record.proposed < 500))
      << record.seconds;
}

class Statistics : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rooms, Statistics,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

// One chain, whose steps are the work of three groups in turn: their merged statistics are those of
// the whole, but for runs of refusals, which belong to the chain.
TEST_P(Statistics, AreThoseOfARecount) {
  const FlatScene scene = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
  const Flat space(*scene, Roulette::off);
  const Family family = make_family({}, space.max_vertices());
  Starts<Flat> starts(space, 1);
  std::uint64_t first = 0;
  while (!(starts.draw(first) > 0)) ++first;
  Chain chain(space, family, starts.path());
  Rng random(1, Purpose::test, 41);
  const MutationStatistics none(Family::names, scene->bins(), space.max_vertices());
  std::vector<MutationStatistics> groups(3, none);
  std::array<Recounts, Family::count> recounts;
  RejectionRuns runs(Family::count);
  Features current = features(space, chain.current());
  std::uint64_t run = 0, longest_run = 0;
  for (std::uint64_t i = 0; i < 9'000; ++i) {
    random.start(i);
    MutationStatistics& group = groups[i / 3'000];
    group.timed(i, [&] {
      int mutation = 0;
      chain.step(random, [&](const Step<W>& step) {
        EXPECT_EQ(current.path_class, path_class_of(step.current));
        EXPECT_EQ(current.bin, space.bin(step.current));
        group.observe(observation(space, step, current), runs);
        mutation = step.mutation;
        recounts[static_cast<std::size_t>(mutation)].add(space, step);
        run = step.accepted() ? 0 : run + 1;
        longest_run = std::max(longest_run, run);
        if (step.accepted()) current = features(space, step.proposed);
      });
      return mutation;
    });
  }
  MutationStatistics all = none;
  for (const MutationStatistics& group : groups) all.merge(group);
  EXPECT_EQ(all.steps(), 9'000u);
  EXPECT_EQ(all.longest_rejection_run(), longest_run);
  const std::vector<MutationRecord> records = all.records();
  std::size_t acted = 0;
  for (std::size_t m = 0; m < Family::count; ++m) {
    if (recounts[m].all.proposed == 0) continue;
    ASSERT_LT(acted, records.size());
    EXPECT_EQ(records[acted].name, Family::names[m]);
    expect_equal(records[acted++], recounts[m]);
  }
  EXPECT_EQ(acted, records.size());
}

// Steps that are refused take time, too: of one that is measured as often as another, so much for each.
TEST(StatisticsOfTime, CountEveryStep) {
  constexpr std::array<std::string_view, 2> names{"refused", "accepted"};
  MutationStatistics statistics(names, 1, 8);
  RejectionRuns runs(2);
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    const int mutation = i % 2000 < 1000 ? 0 : 1;
    statistics.timed(i, [&] {
      Observation seen;
      seen.mutation = mutation;
      seen.reason = mutation == 0 ? Reason::occluded : Reason::none;
      seen.current.vertices = 2;
      statistics.observe(seen, runs);
      return mutation;
    });
  }
  const std::vector<MutationRecord> records = statistics.records();
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].accepted, 0u);
  EXPECT_EQ(records[1].accepted, 10'000u);
  for (const MutationRecord& record : records) EXPECT_GT(record.seconds, 0);
}

// Classes beyond the table are counted, though not by name; long paths share the last length.
TEST(StatisticsOfManyClasses, LoseNoProposal) {
  constexpr std::array<std::string_view, 1> names{"only"};
  MutationStatistics statistics(names, 1, 1000);
  RejectionRuns runs(1);
  for (int k = 0; k < 999; ++k) {
    Observation seen;
    seen.current.vertices = k + 2;
    seen.current.path_class = static_cast<PathClass>(k + 1);
    seen.reason = Reason::occluded;
    statistics.observe(seen, runs);
  }
  const MutationRecord record = statistics.records().at(0);
  std::uint64_t lengths = 0, classes = 0;
  for (const PathsRecord& part : record.by_length) lengths += part.proposed;
  for (const PathsRecord& part : record.by_class) classes += part.proposed;
  EXPECT_EQ(lengths, 999u);
  EXPECT_EQ(classes, 999u);
  EXPECT_EQ(record.by_length.back().vertices, MutationStatistics::most_vertices);
  EXPECT_EQ(record.by_class.back().path_class, "other");
  EXPECT_EQ(record.by_class.back().proposed, 999 - ClassTable::most_classes);
  EXPECT_EQ(record.longest_rejection_run, 999u);
  EXPECT_EQ(record.squared_jump, 0);
  EXPECT_TRUE(std::isnan(record.seconds));  // no step was measured
}

}  // namespace
}  // namespace wander::test
