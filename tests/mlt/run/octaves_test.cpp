// What the states of primary chains tell the bridge is of the law that it takes them for: l = f / p̄, each in proportion to f.
#include "tests/mlt/run/octaves.h"

#include <gtest/gtest.h>

#include <memory>

#include "mlt/primary/primary_estimator.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/kelemen.h"
#include "tests/support/test_scenes.h"

namespace wander::test::octaves_test {
namespace {

using Flat = Transport<Flatland>;
using Pssmlt = PssmltGroup<Flat, Kelemen, KelemenWeights>;
using Mmlt = MmltGroup<Flat, Kelemen, ExpectedValues>;

constexpr int groups = 32;
// A normal number is beyond 5.5 once in 2.6e7; of groups there are 31 degrees of freedom, so once in some 2e5, for each of
// fifty octaves.
constexpr double most_errors = 5.5;

// Of all strata.  Where an l is `factor` times what it is, it is another law.
template <class Group>
double difference(double factor) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  std::vector<std::unique_ptr<Group>> all;
  SeedTally others(space.max_vertices());
  for (int g = 0; g < groups; ++g) {
    Group& group =
        *all.emplace_back(std::make_unique<Group>(space, PrimaryKernel{Kelemen{}, 0.3}, 7, g, 2));
    group.add_seeds(2000);
    others.merge(group.tally());
  }
  std::vector<GroupFindings> findings;
  for (const auto& group : all) {
    group->end_seeds();
    group->start_chains(others);
    group->advance(6000);
    findings.push_back(group->findings());
  }
  std::vector<RatioHistogram> states;
  const std::size_t strata = findings.front().states.size();
  states.reserve(strata * groups);
  for (GroupFindings& group : findings)
    for (auto& of_stratum : group.states) {
      RatioHistogram& moved = states.emplace_back();
      const RatioHistogram& seen = *of_stratum.ratios;
      for (int i = seen.first(); i < seen.end(); ++i)
        if (seen[i].count > 0) moved.add(factor * RatioHistogram::middle(i), seen[i].count);
      of_stratum.ratios = &moved;
    }
  double largest = 0;
  for (std::size_t k = 0; k < strata; ++k)
    largest = std::max(largest, largest_difference(findings, k));
  return largest;
}

TEST(OctavesOfPrimaryStates, AreThoseOfTheLightThatSamplesFind) {
  EXPECT_LT(difference<Pssmlt>(1), most_errors);
  EXPECT_LT(difference<Mmlt>(1), most_errors);
}

TEST(OctavesOfPrimaryStates, OfAnotherLawAreTold) {
  EXPECT_GT(difference<Pssmlt>(3), 2 * most_errors);
  EXPECT_GT(difference<Mmlt>(3), 2 * most_errors);
}

}  // namespace
}  // namespace wander::test::octaves_test
