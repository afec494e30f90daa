// References made by two methods: their mean, and whether they agree.
#include "lab/compare/reference_pool.h"

#include <gtest/gtest.h>

#include "tests/lab/compare/made_runs.h"
#include "tests/tools/command_line.h"

namespace wander::test::reference_pool_test {
namespace {

using namespace compare;

constexpr std::size_t bins = 32;
constexpr double error = 0.1;

// A film whose errors were told by 32 groups: x ± s with s² ~ χ² of 31 degrees.
FilmEstimate told_by_groups(Generator& random) {
  FilmEstimate film = made_film(std::vector<double>(bins), error);
  for (std::size_t b = 0; b < bins; ++b) {
    double chi2 = 0;
    for (int i = 0; i < 31; ++i) chi2 += std::pow(random.normal(), 2);
    film.value[b] = 1 + error * random.normal();
    film.standard_error[b] = error * std::sqrt(chi2 / 31);
  }
  return film;
}

Part part(std::string made_by, const FilmEstimate& film, double weight) {
  Rendering run{.samples = 1000, .seconds = 1, .film = film};
  return {std::move(made_by), {run}, weight};
}

// 4 false alarms in 4000 are expected; more than 18 have probability 1e-8.
TEST(Agreement, FalseAlarmsAreAsRareAsStated) {
  Generator random(1);
  int alarms = 0;
  for (int i = 0; i < 4000; ++i)
    if (!agreement(told_by_groups(random), told_by_groups(random))) ++alarms;
  EXPECT_LE(alarms, 18);
}

// The wrong twin: one bin lacks light of eight standard errors of the difference.  With 62 degrees
// and a threshold of 4.4 it is missed once in 3000 times; more than 6 of 300 have probability 1e-9.
TEST(Agreement, LightThatOneMissesIsFound) {
  Generator random(2);
  int missed = 0;
  for (int i = 0; i < 300; ++i) {
    FilmEstimate blind = told_by_groups(random);
    blind.value[7] -= 8 * std::sqrt(2) * error;
    if (agreement(told_by_groups(random), blind)) ++missed;
  }
  EXPECT_LE(missed, 6);
}

TEST(Agreement, ADarkBinIsHeldAgainstOneThatIsLit) {
  Generator random(3);
  const FilmEstimate lit = told_by_groups(random);
  FilmEstimate dark = lit;
  dark.value[3] = dark.standard_error[3] = 0;
  dark.reliable[3] = false;
  const Decision decision = agreement(lit, dark);
  EXPECT_FALSE(decision);
  EXPECT_EQ(decision.worst, 3u);
  FilmEstimate unknown = lit;  // control: unreliable, but not dark
  unknown.value[3] = 0.1;
  unknown.reliable[3] = false;
  EXPECT_TRUE(agreement(lit, unknown));
}

TEST(Agreement, NothingToCompareIsNoDisagreement) {
  const FilmEstimate dark = made_film(std::vector<double>(bins, 0.0), 0);
  EXPECT_TRUE(agreement(dark, dark));
}

TEST(ReferencePool, IsTheMeanByWeight) {
  const Part a = part("bdpt", made_film({1, 2}, 0.1), 3),
             b = part("mlt", made_film({1.5, 2}, 0.2), 1);
  const Reference reference = pooled_reference({a, b});
  EXPECT_DOUBLE_EQ(reference.film.value[0], 1.125);
  EXPECT_DOUBLE_EQ(reference.film.value[1], 2);
  EXPECT_DOUBLE_EQ(reference.film.standard_error[0], std::hypot(0.075, 0.05));
  EXPECT_GT(reference.film.degrees_of_freedom, 31);
  EXPECT_LE(reference.film.degrees_of_freedom, 62);
  EXPECT_HAS(reference.origin,
             "of bdpt (1000 samples, 1 s), weight 0.75, and 1 independent run of mlt");
  EXPECT_TRUE(reference.doubts.empty());
}

TEST(ReferencePool, DisagreementIsSaidAndRaisesTheError) {
  Generator random(4);
  FilmEstimate blind = told_by_groups(random);
  for (double& x : blind.value) x -= 1;
  const FilmEstimate whole = told_by_groups(random);
  const Reference reference = pooled_reference({part("bdpt", whole, 1), part("pt", blind, 1)});
  ASSERT_EQ(reference.doubts.size(), 1u);
  EXPECT_HAS(reference.doubts.front(), "bdpt and pt, do not agree (in bin ");
  EXPECT_GT(reference.film.standard_error[0], 0.3);  // half of what they differ by is 0.5
}

TEST(ReferencePool, OneAloneIsADoubt) {
  const Reference reference = pooled_reference({part("mlt", made_film({1, 2}, 0.1), 1)});
  ASSERT_EQ(reference.doubts.size(), 1u);
  EXPECT_HAS(reference.doubts.front(), "mlt alone");
}

TEST(ReferencePool, ADoubtIsAmongTheCautions) {
  Generator random(5);
  Runs runs = made_runs({}, {{"a", 0.1}, {"b", 0.3}}, random);
  EXPECT_TRUE(summarize(runs).cautions.empty());
  runs.reference.doubts = {"This may be wrong."};
  EXPECT_EQ(summarize(runs).cautions, runs.reference.doubts);
}

// Of light of 1e±200 the squares are no numbers.
TEST(ReferencePool, KeepsItsErrorsWhateverTheLight) {
  for (const double power : {1e200, 1e-200}) {
    Generator random(6);
    FilmEstimate a = told_by_groups(random), b = told_by_groups(random);
    const Reference plain = pooled_reference({part("a", a, 1), part("b", b, 2)});
    for (FilmEstimate* film : {&a, &b})
      for (std::size_t j = 0; j < bins; ++j) {
        film->value[j] *= power;
        film->standard_error[j] *= power;
      }
    const Reference scaled = pooled_reference({part("a", a, 1), part("b", b, 2)});
    EXPECT_TRUE(scaled.doubts.empty());
    EXPECT_NEAR(scaled.film.degrees_of_freedom, plain.film.degrees_of_freedom, 1e-6);
    EXPECT_NEAR(scaled.film.standard_error[0] / power, plain.film.standard_error[0], 1e-12);
  }
}

}  // namespace
}  // namespace wander::test::reference_pool_test
