// What a mutation did in each bin of the film, from steps made up by hand.
#include <gtest/gtest.h>

#include "mlt/watch/statistics.h"

namespace wander::test {
namespace {

TEST(BinRecords, HaveTheMeanAcceptanceOfTheProposalsMadeThere) {
  constexpr std::array<std::string_view, 1> names{"only"};
  MutationStatistics statistics(names, 3, 4);
  RejectionRuns runs(1);
  const auto observe = [&](int bin, double acceptance, Reason reason) {
    Observation seen;
    seen.reason = reason;
    seen.acceptance = acceptance;
    seen.current.bin = bin;
    seen.current.vertices = 2;
    statistics.observe(seen, runs);
  };
  observe(0, 0.75, Reason::none);
  observe(0, 0.25, Reason::metropolis);
  observe(0, 0, Reason::occluded);
  observe(2, 0.5, Reason::metropolis);
  const MutationRecord record = statistics.records().at(0);
  EXPECT_EQ(record.proposed_per_bin, (std::vector<double>{3, 0, 1}));
  EXPECT_DOUBLE_EQ(record.acceptance_per_bin[0], 1.0 / 3);
  EXPECT_EQ(record.acceptance_per_bin[1], 0);
  EXPECT_EQ(record.acceptance_per_bin[2], 0.5);
}

}  // namespace
}  // namespace wander::test
