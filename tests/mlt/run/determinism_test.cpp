// The same numbers from any number of threads; budgets that are met to the sample.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "lab/estimate.h"
#include "lab/render.h"
#include "mutations/catalogue.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

Session session_of(std::uint64_t samples, int threads) {
  Session session;
  session.budget = SampleBudget{samples};
  session.threads = threads;
  return session;
}
Rendering mlt(const Scene<Flatland>& scene, const Session& session) {
  const Flat space(scene, Roulette::off);
  const Family family = make_family({}, scene.max_vertices());
  return ChainRenderer(space, family, session, ChainSettings{.fewest_seeds = 4096}).render("mlt");
}
Rendering independent(const Scene<Flatland>& scene, const Session& session, const char* name) {
  for (const Estimator& estimator : estimators())
    if (std::string_view(estimator.name) == name) return estimate(scene, estimator, session);
  throw std::logic_error("no such estimator");
}

void expect_same(const std::vector<PathsRecord>& a, const std::vector<PathsRecord>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].vertices, b[k].vertices);
    EXPECT_EQ(a[k].path_class, b[k].path_class);
    EXPECT_EQ(a[k].proposed, b[k].proposed);
    EXPECT_EQ(a[k].accepted, b[k].accepted);
    EXPECT_EQ(a[k].mean_acceptance, b[k].mean_acceptance);
    EXPECT_EQ(a[k].failures, b[k].failures);
  }
}
// Bit for bit; a NaN is itself.
std::vector<std::uint64_t> bits_of(const ChainsRecord& chains) {
  std::vector<std::uint64_t> bits{chains.draws, chains.stride, chains.longest_rejection_run};
  for (const FunctionalRecord& f : chains.functionals)
    for (const double x : {f.r_hat, f.ess_bulk, f.ess_tail, f.autocorrelation_time})
      bits.push_back(std::isnan(x) ? 0 : std::bit_cast<std::uint64_t>(x));
  return bits;
}
// All but the times.
void expect_same(const Rendering& a, const Rendering& b) {
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.film.value, b.film.value);
  EXPECT_EQ(a.film.standard_error, b.film.standard_error);
  EXPECT_EQ(a.film.reliable, b.film.reliable);
  EXPECT_EQ(a.film.by_length, b.film.by_length);
  EXPECT_EQ(a.film.degrees_of_freedom, b.film.degrees_of_freedom);
  ASSERT_EQ(a.normalization.has_value(), b.normalization.has_value());
  if (a.normalization) {
    EXPECT_EQ(a.normalization->value, b.normalization->value);
    EXPECT_EQ(a.normalization->standard_error, b.normalization->standard_error);
    for (std::size_t k = 0; k < a.normalization->by_length.size(); ++k)
      EXPECT_EQ(a.normalization->by_length[k].value, b.normalization->by_length.at(k).value);
  }
  ASSERT_EQ(a.mutations.size(), b.mutations.size());
  for (std::size_t m = 0; m < a.mutations.size(); ++m) {
    EXPECT_EQ(a.mutations[m].proposed, b.mutations[m].proposed);
    EXPECT_EQ(a.mutations[m].accepted, b.mutations[m].accepted);
    EXPECT_EQ(a.mutations[m].mean_acceptance, b.mutations[m].mean_acceptance);
    EXPECT_EQ(a.mutations[m].failures, b.mutations[m].failures);
    EXPECT_EQ(a.mutations[m].proposed_per_bin, b.mutations[m].proposed_per_bin);
    EXPECT_EQ(a.mutations[m].acceptance_per_bin, b.mutations[m].acceptance_per_bin);
    EXPECT_EQ(a.mutations[m].squared_jump, b.mutations[m].squared_jump);
    EXPECT_EQ(a.mutations[m].longest_rejection_run, b.mutations[m].longest_rejection_run);
    expect_same(a.mutations[m].by_length, b.mutations[m].by_length);
    expect_same(a.mutations[m].by_class, b.mutations[m].by_class);
  }
  ASSERT_EQ(a.chains_record.has_value(), b.chains_record.has_value());
  if (a.chains_record) {
    EXPECT_EQ(bits_of(*a.chains_record), bits_of(*b.chains_record));
  }
  EXPECT_EQ(a.warnings, b.warnings);
}

class Threads : public ::testing::TestWithParam<int> {
 protected:
  FlatScene scene_ = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
};
INSTANTIATE_TEST_SUITE_P(Rooms, Threads,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST_P(Threads, DoNotChangeABitOfWhatChainsCompute) {
  Session session = session_of(30'001, 1);
  const Rendering one = mlt(*scene_, session);
  for (const int threads : {2, 7}) {
    session.threads = threads;
    expect_same(one, mlt(*scene_, session));
  }
  session.seed = 2;
  EXPECT_NE(one.film.value, mlt(*scene_, session).film.value);
}

TEST_P(Threads, DoNotChangeABitOfWhatIndependentSamplesCompute) {
  for (const char* name : {"bdpt", "pt", "lt"}) {
    Session session = session_of(10'001, 1);
    const Rendering one = independent(*scene_, session, name);
    for (const int threads : {2, 7}) {
      session.threads = threads;
      expect_same(one, independent(*scene_, session, name));
    }
    session.seed = 2;
    EXPECT_NE(one.film.value, independent(*scene_, session, name).film.value);
  }
}

TEST(BudgetOfARun, InMutationsIsMetExactly) {
  const FlatScene scene = build(diffuse_room());
  for (const std::uint64_t budget : {1u, 2u, 63u, 64u, 255u, 257u, 1000u, 100'003u}) {
    SCOPED_TRACE(budget);
    const Rendering r = mlt(*scene, session_of(budget, 2));
    EXPECT_EQ(r.samples, budget);
    EXPECT_TRUE(r.complete);
    std::uint64_t proposed = 0;
    for (const MutationRecord& m : r.mutations) {
      proposed += m.proposed;
      std::uint64_t outcomes = m.accepted;
      for (const auto& [reason, count] : m.failures) outcomes += count;
      EXPECT_EQ(outcomes, m.proposed);
    }
    EXPECT_EQ(proposed, budget);
  }
}

TEST(BudgetOfARun, InSamplesIsMetExactly) {
  const FlatScene scene = build(diffuse_room());
  for (const std::uint64_t budget : {1u, 63u, 4096u, 4097u, 100'003u}) {
    const Rendering r = independent(*scene, session_of(budget, 2), "bdpt");
    EXPECT_EQ(r.samples, budget);
    EXPECT_TRUE(r.complete);
  }
}

// The deposits of a group sum to its steps, so the mean of the film is the mean of the groups' b,
// however long the chains are.
TEST(FilmOfChains, HasTheMeanOfTheNormalization) {
  const FlatScene scene = build(diffuse_room());
  for (const std::uint64_t budget : {64u, 1000u, 100'003u}) {
    const Rendering r = mlt(*scene, session_of(budget, 2));
    double mean = 0;
    for (const double value : r.film.value)
      mean += value / static_cast<double>(r.film.value.size());
    EXPECT_NEAR(mean, r.normalization->value, 1e-12 * mean);
  }
}

}  // namespace
}  // namespace wander::test
