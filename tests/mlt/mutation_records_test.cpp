// What is told of the mutations: counts, means and reasons, from steps made up by hand.
#include "mlt/statistics.h"

#include <gtest/gtest.h>

#include "core/world.h"

namespace wander::test {
namespace {

using W = Flatland;
constexpr std::array<std::string_view, 3> names{"first", "second", "idle"};

class MutationRecords : public ::testing::Test {
 protected:
  void observe(MutationStatistics& statistics, int mutation, int bin, double a, Reason reason) {
    statistics.observe(Step<W>{x_, y_, mutation, Proposal{1, 1}, a, reason}, bin);
  }
  // Three steps of the first mutation, one of the second.
  MutationStatistics four_steps() {
    MutationStatistics statistics(names, 2);
    observe(statistics, 0, 0, 0.75, Reason::none);
    observe(statistics, 0, 0, 0.25, Reason::metropolis);
    observe(statistics, 0, 1, 0, Reason::occluded);
    observe(statistics, 1, 1, 1, Reason::none);
    return statistics;
  }

 private:
  Path<W> x_{2}, y_{2};
};

TEST_F(MutationRecords, CountTheirStepsAndAverageTheirAcceptance) {
  const MutationStatistics statistics = four_steps();
  EXPECT_EQ(statistics.steps(), 4u);
  const auto records = statistics.records();
  ASSERT_EQ(records.size(), 2u) << "a mutation that made no step has no record";
  EXPECT_EQ(records[0].name, "first");
  EXPECT_EQ(records[0].proposed, 3u);
  EXPECT_EQ(records[0].accepted, 1u);
  EXPECT_DOUBLE_EQ(records[0].mean_acceptance, 1.0 / 3);
  EXPECT_EQ(records[0].failures,
            (std::map<std::string, std::uint64_t>{{"metropolis", 1}, {"occluded", 1}}));
  EXPECT_EQ(records[0].proposed_per_bin, (std::vector<double>{2, 1}));
  EXPECT_EQ(records[0].acceptance_per_bin, (std::vector<double>{0.5, 0}));
  EXPECT_EQ(records[1].name, "second");
  EXPECT_EQ(records[1].acceptance_per_bin, (std::vector<double>{0, 1}));
}

TEST_F(MutationRecords, OfTwoGroupsAddUp) {
  MutationStatistics statistics = four_steps();
  MutationStatistics other(names, 2);
  observe(other, 0, 1, 1, Reason::none);
  observe(other, 2, 0, 0, Reason::occluded);
  statistics.merge(other);
  EXPECT_EQ(statistics.steps(), 6u);
  const auto records = statistics.records();
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[0].proposed, 4u);
  EXPECT_EQ(records[0].accepted, 2u);
  EXPECT_DOUBLE_EQ(records[0].mean_acceptance, 0.5);
  EXPECT_EQ(records[0].proposed_per_bin, (std::vector<double>{2, 2}));
  EXPECT_EQ(records[0].acceptance_per_bin, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(records[2].failures, (std::map<std::string, std::uint64_t>{{"occluded", 1}}));
}

}  // namespace
}  // namespace wander::test
