// What one step of a chain may and may not do.
#include "mlt/chain.h"

#include <gtest/gtest.h>

#include <limits>

#include "mutations/catalogue.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/invariance.h"
#include "tests/support/path_equality.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// ---- steps

// Proposes the current path, changed by `change`, with the densities given.
template <class Change>
struct Fixed {
  static constexpr std::string_view name = "fixed";
  Proposed answer;
  Change change;

  template <class Space>
  double applicability(const Space&, const Path<W>&) const {
    return 1;
  }
  template <class Space, class Random>
  Proposed propose(const Space&, const Path<W>& x, Path<W>& y, Random&) const {
    y = x;
    y.resize(x.size());  // so that it is weighed anew
    change(y);
    return answer;
  }
};

class ChainStep : public ::testing::Test {
 protected:
  Path<W> seed(const Flat& space) const {
    Starts<Flat> starts(space, 1);
    for (std::uint64_t i = 0;; ++i)
      if (starts.draw(i) > 0) return starts.path();
  }

  // What one step with such a proposal comes to.
  template <class Change>
  Reason reason(Proposed answer, Change change) const {
    const auto kernel = alone(Fixed<Change>{answer, change});
    Chain chain(space_, kernel, seed(space_));
    const Path<W> before = chain.current();
    Rng random(1, Purpose::test, 30);
    Reason reason{};
    chain.step(random, [&](const Step<W>& step) { reason = step.reason; });
    if (reason != Reason::none) {
      EXPECT_TRUE(identical(before, chain.current()));
    }
    return reason;
  }
  Reason reason(Proposed answer) const {
    return reason(answer, [](Path<W>&) {});
  }

  FlatScene scene_ = build(diffuse_room());
  Flat space_{*scene_, Roulette::off};
  static constexpr double nan_ = std::numeric_limits<double>::quiet_NaN();
  static constexpr double infinity_ = std::numeric_limits<double>::infinity();
};

TEST_F(ChainStep, AnEquallyGoodProposalIsAccepted) {
  EXPECT_EQ(reason(Proposal{1, 1}), Reason::none);
}
TEST_F(ChainStep, AContributionThatIsNoNumberIsRefused) {
  for (const double value : {nan_, infinity_, -1.0}) {
    EXPECT_EQ(reason(Proposal{1, 1}, [value](Path<W>& y) { y[0].value = value; }),
              Reason::not_finite);
  }
  EXPECT_EQ(reason(Proposal{1, 1}, [](Path<W>& y) { y[0].geometry = nan_; }), Reason::not_finite);
}
TEST_F(ChainStep, ADarkProposalIsRefused) {
  EXPECT_EQ(reason(Proposal{1, 1}, [](Path<W>& y) { y[0].value = 0; }), Reason::zero_contribution);
}
TEST_F(ChainStep, DensitiesThatAreNoNumbersAreRefused) {
  for (const double density : {nan_, infinity_, -1.0}) {
    EXPECT_EQ(reason(Proposal{density, 1}), Reason::not_finite);
    EXPECT_EQ(reason(Proposal{1, density}), Reason::not_finite);
  }
  EXPECT_EQ(reason(Proposal{0, 1}), Reason::not_finite);
  EXPECT_EQ(reason(Proposal{1, 0}), Reason::not_reversible);
}
// A replayed seed brings no intensity and no weights of its own.
TEST_F(ChainStep, BeginsWithASeedThatTheChainHasMeasured) {
  const auto nothing = [](Path<W>&) {};
  const auto kernel = alone(Fixed<decltype(nothing)>{Proposal{1, 1}, nothing});
  Path<W> unmeasured = seed(space_), measured = unmeasured;
  weigh(space_, measured);
  unmeasured.weights().clear();
  unmeasured.contribution = unmeasured.intensity = unmeasured.intensity_under_roulette = 0;
  EXPECT_TRUE(identical(Chain(space_, kernel, unmeasured).current(), measured));
}
TEST_F(ChainStep, AFailureKeepsItsReason) {
  EXPECT_EQ(reason(Failure{Reason::occluded}), Reason::occluded);
}

class FamilySteps : public ::testing::TestWithParam<int> {
 protected:
  NamedScene named_ = lit_scenes()[static_cast<std::size_t>(GetParam())];
  FlatScene scene_ = build(named_.scene);
  Flat space_{*scene_, Roulette::off};
  Family family_ = make_family({}, scene_->max_vertices());
  Starts<Flat> starts_{space_, 1};

  const Path<W>& start() {
    for (std::uint64_t i = 0;; ++i)
      if (starts_.draw(i) > 0) return starts_.path();
  }
};

TEST_P(FamilySteps, ARejectedStepLeavesTheStateAsItWasBitForBit) {
  Chain chain(space_, family_, start());
  Rng random(2, Purpose::test, 31);
  Path<W> before = chain.current();
  int accepted = 0, rejected = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    random.start(i);
    bool moved = false;
    chain.step(random, [&](const Step<W>& step) { moved = step.accepted(); });
    if (!moved) {
      ASSERT_TRUE(identical(before, chain.current()));
    }
    (moved ? accepted : rejected)++;
    before = chain.current();
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(rejected, 100);
}

TEST_P(FamilySteps, AnObserverSeesTheCurrentPathAndTheProposal) {
  Chain chain(space_, family_, start());
  Rng random(3, Purpose::test, 32);
  Path<W> before = chain.current();
  for (std::uint64_t i = 0; i < 5000; ++i) {
    random.start(i);
    Path<W> proposed(space_.max_vertices());
    bool accepted = false;
    chain.step(random, [&](const Step<W>& step) {
      ASSERT_TRUE(identical(before, step.current));
      const bool weighed = std::holds_alternative<Proposal>(step.outcome);
      ASSERT_EQ(weighed, step.reason == Reason::none || step.reason == Reason::metropolis);
      ASSERT_GE(step.acceptance, 0);
      ASSERT_LE(step.acceptance, 1);
      if (weighed) {
        ASSERT_EQ(step.proposed.contribution, contribution(step.proposed));
      } else {
        ASSERT_EQ(step.acceptance, 0);
      }
      accepted = step.accepted();
      proposed = step.proposed;
    });
    if (accepted) {
      weigh(space_, proposed);
      ASSERT_TRUE(identical(proposed, chain.current()));
    }
    before = chain.current();
  }
}

// What is stored with a path is what its vertices give when everything is computed anew.
TEST_P(FamilySteps, TheStateIsNeverStale) {
  Chain chain(space_, family_, start());
  Rng random(4, Purpose::test, 33);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    random.start(i);
    chain.step(random, [](const Step<W>&) {});
    const Path<W>& x = chain.current();
    Path<W> fresh = x;
    for (int k = 0; k < x.size(); ++k) space_.evaluate(fresh, k);
    weigh(space_, fresh);
    ASSERT_TRUE(identical(x, fresh)) << path_class(x);
    double sum = 0;
    for (const double w : x.weights()) sum += w;
    ASSERT_NEAR(sum, 1, 1e-12);
  }
}

TEST_P(FamilySteps, NeverAllocate) {
  Chain chain(space_, family_, start());
  Rng random(5, Purpose::test, 34);
  const AllocationCounter allocations;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    random.start(i);
    chain.step(random, [](const Step<W>&) {});
  }
  EXPECT_EQ(allocations.count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Rooms, FamilySteps,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST(AllocationCounter, CountsWhatIsAllocated) {
  const AllocationCounter allocations;
  std::vector<double>(100).swap(*std::make_unique<std::vector<double>>());
  EXPECT_GE(allocations.count(), 1);
}

}  // namespace
}  // namespace wander::test
