// Runs of different seeds, merged: what comes out is recounted from what each of them says alone.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/film_statistics.h"
#include "lab/engine.h"
#include "lab/failure.h"
#include "records/run_json.h"
#include "tests/support/test_scenes.h"

namespace wander::test::merge_test {
namespace {

using nlohmann::ordered_json;

struct Kept {
  std::uint64_t seed;
  std::string state;
  Rendering found;
};

Kept kept_run(const Job& job, std::uint64_t seed, const Budget& budget) {
  Session session;
  session.budget = budget;
  session.seed = seed;
  session.threads = 2;
  Kept kept{seed, {}, {}};
  const Keeper keeper{[&](const Headway&, const StateWriter& state) {
                        std::ostringstream bytes;
                        state(bytes);
                        kept.state = bytes.str();
                      },
                      0, 0};
  kept.found = carry_on({}, job, session, keeper);
  return kept;
}
Kept kept_run(const Job& job, std::uint64_t seed, std::uint64_t samples) {
  return kept_run(job, seed, Budget{SampleBudget{samples}});
}

Rendering merged(const Job& job, const std::vector<Kept>& runs, int threads = 2) {
  std::vector<StoredRun> stored;
  for (const Kept& run : runs) stored.push_back({run.seed, [&run] { return run.state; }, "none"});
  Session session;
  session.threads = threads;
  return merge(job, stored, session);
}

// Every number of run.json but times, seed and budget.
ordered_json numbers_of(const Rendering& rendering) {
  ordered_json json = to_json(RunRecord{rendering, {}});
  for (const char* fact :
       {"threads", "seconds", "cpu_seconds", "seed_seconds", "command_line", "seed", "complete"})
    json.erase(fact);
  if (json.contains("chains")) json["chains"].erase("ess_per_second");
  return json;
}

void expect_close(double a, double b, double relative) {
  EXPECT_NEAR(a, b, relative * std::abs(b)) << a - b;
}

class Merged : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, Merged,
                         ::testing::Values("pt", "lt", "bdpt", "pt-naive", "lt-naive", "mlt",
                                           "pssmlt", "mmlt"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// What is made of one is made by the same text.
TEST_P(Merged, OneRunIsThatRun) {
  for (const Precision precision : {Precision::of_double, Precision::of_float}) {
    const Job job(mirror_and_glass(), find_method(GetParam()), {.precision = precision});
    const Kept run = kept_run(job, 7, 20'011);
    EXPECT_EQ(ordered_json::diff(numbers_of(merged(job, {run})), numbers_of(run.found)),
              ordered_json::array());
  }
}

TEST_P(Merged, HaveTheSameBitsForAnyThreads) {
  const Job job(mirror_and_glass(), find_method(GetParam()));
  const std::vector<Kept> runs{kept_run(job, 1, 5'000), kept_run(job, 2, 11'000)};
  EXPECT_EQ(numbers_of(merged(job, runs, 1)), numbers_of(merged(job, runs, 3)));
}

// ---- independent samples

// Σ x and Σ x² of each bin follow from its value and standard error.
TEST(MergedSamples, AreThoseOfAllRunsTogether) {
  const Job job(mirror_and_glass(), find_method("bdpt"));
  const std::vector<Kept> runs{kept_run(job, 1, 5'000), kept_run(job, 2, 20'000),
                               kept_run(job, 9, 9'999)};
  const Rendering all = merged(job, runs);
  ASSERT_EQ(all.samples, 34'999u);
  const double n = 34'999;
  const auto bins = static_cast<double>(all.film.value.size());
  for (std::size_t j = 0; j < all.film.value.size(); ++j) {
    double sum = 0, squares = 0;
    for (const Kept& run : runs) {
      const auto its = static_cast<double>(run.found.samples);
      const double x = run.found.film.value[j] * its / bins;
      sum += x;
      squares +=
          std::pow(run.found.film.standard_error[j] / bins, 2) * its * (its - 1) + x * x / its;
    }
    expect_close(all.film.value[j], bins * sum / n, 1e-14);
    expect_close(all.film.standard_error[j],
                 bins * std::sqrt((squares - sum * sum / n) / (n - 1) / n), 1e-9);
  }
  EXPECT_EQ(all.film.degrees_of_freedom, n - 1);
}

// ---- chains

Job chains_job(NormalizationMethod normalization = NormalizationMethod::bridge,
               FilmParts parts = FilmParts::chains, std::optional<double> seed_share = {}) {
  return {
      mirror_and_glass(),
      find_method("mlt"),
      {.chains = {.film_parts = parts, .seed_share = seed_share, .normalization = normalization}}};
}

const NormalizationEstimate& seed_pass_of(const Rendering& run) {
  return run.normalization->estimates.at("seed_pass");
}

// The deposits of a step sum to one: Σ_j F_gj of a group is its b_g, and their sum over a run is
// that of as many groups as it has times its own mean.  The film of a run, over its b, says how they
// are spread.
TEST(MergedChains, HaveTheFilmOfAllGroupsByTheirSizes) {
  const Job job = chains_job();
  const std::vector<Kept> runs{kept_run(job, 1, 5'000), kept_run(job, 2, 15'000),
                               kept_run(job, 3, 50'000)};
  const Rendering all = merged(job, runs);
  const std::size_t bins = all.film.value.size();
  std::vector<double> light(bins);
  double mass = 0, found = 0, samples = 0;
  for (const Kept& run : runs) {
    const double seeds = static_cast<double>(seed_pass_of(run.found).samples);
    const double size = 1 / (1 / static_cast<double>(run.found.samples) + 0.25 / seeds);
    const double b = seed_pass_of(run.found).value;
    for (std::size_t j = 0; j < bins; ++j)
      light[j] += size * b * run.found.film.value[j] / run.found.normalization->value;
    mass += size * b;
    found += seeds * b;
    samples += seeds;
  }
  expect_close(seed_pass_of(all).value, found / samples, 1e-13);
  EXPECT_EQ(static_cast<double>(seed_pass_of(all).samples), samples);
  for (std::size_t j = 0; j < bins; ++j)
    expect_close(all.film.value[j], all.normalization->value * light[j] / mass, 1e-12);
  EXPECT_EQ(all.normalization->method, "bridge");
  EXPECT_EQ(all.groups, 3 * 64);
  EXPECT_EQ(all.samples, 70'000u);
}

TEST(MergedChains, ScaledToTheSeedPassHaveTheMeanOfTheirFilms) {
  const Job job = chains_job(NormalizationMethod::seed_pass);
  const std::vector<Kept> runs{kept_run(job, 1, 100'000), kept_run(job, 2, 400'000)};
  const Rendering all = merged(job, runs);
  const double n1 = static_cast<double>(seed_pass_of(runs[0].found).samples),
               n2 = static_cast<double>(seed_pass_of(runs[1].found).samples);
  ASSERT_LT(n1, n2);
  const FilmEstimate &a = runs[0].found.film, &b = runs[1].found.film;
  double mean = 0;
  for (std::size_t j = 0; j < all.film.value.size(); ++j) {
    expect_close(all.film.value[j], (n1 * a.value[j] + n2 * b.value[j]) / (n1 + n2), 1e-13);
    expect_close(all.film.standard_error[j],
                 std::hypot(n1 * a.standard_error[j], n2 * b.standard_error[j]) / (n1 + n2), 1e-13);
    mean += all.film.value[j] / static_cast<double>(all.film.value.size());
  }
  expect_close(all.normalization->value, mean, 1e-12);
  EXPECT_GT(all.film.degrees_of_freedom, 63);
  EXPECT_LE(all.film.degrees_of_freedom, 126);
}

// Of runs that are alike in size, samples and all, each pooled by a border of its own.
TEST(MergedChains, OfPooledFilmsHaveTheMeanOfThem) {
  const Job job = chains_job(NormalizationMethod::bridge, FilmParts::pooled, 1);
  const std::vector<Kept> runs{kept_run(job, 1, 60'000), kept_run(job, 2, 60'000)};
  ASSERT_NE(runs[0].found.pooling->how.partition.c, runs[1].found.pooling->how.partition.c);
  ASSERT_EQ(runs[0].found.pooling->samples, runs[1].found.pooling->samples);
  const Rendering all = merged(job, runs);
  EXPECT_EQ(all.pooling->samples, 2 * runs[0].found.pooling->samples);
  EXPECT_NEAR(mean_value(all.film), all.normalization->value, 1e-12 * all.normalization->value);
  double light = 0, of_samples = 0;
  for (const ClassRecord& each : all.pooling->classes) light += each.light;
  EXPECT_NEAR(light, 1, 1e-12);
  for (const double value : all.pooling->film_of_samples) of_samples += value;
  EXPECT_NEAR(of_samples / static_cast<double>(all.film.value.size()),
              all.pooling->light_of_samples * mean_value(all.film), 1e-12 * mean_value(all.film));
  const FilmEstimate &a = runs[0].found.film, &b = runs[1].found.film;
  // The levels of both films differ from that of all by their errors.
  const double level = 2 * all.normalization->value / (mean_value(a) + mean_value(b));
  for (std::size_t j = 0; j < a.value.size(); ++j) {
    const double mean = level * (a.value[j] + b.value[j]) / 2;
    EXPECT_NEAR(all.film.value[j], mean, 0.1 * all.film.standard_error[j]) << j;
    const double error = std::hypot(a.standard_error[j], b.standard_error[j]) / 2;
    EXPECT_NEAR(all.film.standard_error[j] / error, 1, 0.3) << j;
  }
}

// However the runs share their work between chains and samples: one of twice the work weighs twice.
TEST(MergedChains, OfPooledFilmsWeighByTheirWork) {
  const Job job = chains_job(NormalizationMethod::bridge, FilmParts::pooled, 1);
  const std::vector<Kept> runs{kept_run(job, 1, 2'000), kept_run(job, 2, 50'000)};
  const auto work = [](const Rendering& run) {
    return static_cast<double>(run.samples) +
           run.pooling->how.cost_of_sample * static_cast<double>(run.pooling->samples);
  };
  const double a = work(runs[0].found), b = work(runs[1].found);
  const auto by_steps = static_cast<double>(runs[1].found.samples) /
                        static_cast<double>(runs[0].found.samples + runs[1].found.samples);
  ASSERT_GT(std::abs(b / (a + b) - by_steps), 0.02) << "the two would not be told apart";
  const Rendering all = merged(job, runs);
  // The share w of the second run, by least squares over the bins, once all have the same level.
  double products = 0, squares = 0;
  const auto of = [](const Rendering& r, std::size_t j) {
    return r.film.value[j] / mean_value(r.film);
  };
  for (std::size_t j = 0; j < all.film.value.size(); ++j) {
    const double step = of(runs[1].found, j) - of(runs[0].found, j);
    products += step * (of(all, j) - of(runs[0].found, j));
    squares += step * step;
  }
  EXPECT_NEAR(products / squares, b / (a + b), 0.01);
}

// The same of large films, whose parts have errors of their own.
TEST(MergedChains, OfLargePooledFilmsHaveTheErrorOfTheirMean) {
  Job job = chains_job(NormalizationMethod::bridge, FilmParts::pooled, 1);
  job = Job(job.scene(), job.method(), {.chains = job.dials().chains, .film = {.most_small = 4}});
  const std::vector<Kept> runs{kept_run(job, 1, 60'000), kept_run(job, 2, 60'000)};
  const Rendering all = merged(job, runs);
  const FilmEstimate &a = runs[0].found.film, &b = runs[1].found.film;
  double of_all = 0, of_each = 0;
  for (std::size_t j = 0; j < a.value.size(); ++j) {
    of_all += std::pow(all.film.standard_error[j], 2);
    of_each += (std::pow(a.standard_error[j], 2) + std::pow(b.standard_error[j], 2)) / 4;
  }
  EXPECT_NEAR(of_all / of_each, 1, 0.3);
}

TEST(MergedChains, CountWhatAllMutationsDid) {
  const Job job = chains_job();
  const std::vector<Kept> runs{kept_run(job, 1, 15'000), kept_run(job, 2, 20'000)};
  const Rendering all = merged(job, runs);
  for (const MutationRecord& mutation : all.mutations) {
    std::uint64_t proposed = 0, accepted = 0, longest = 0;
    double acceptance = 0, jumps = 0;
    std::map<std::string, std::uint64_t> failures;
    for (const Kept& run : runs) {
      const auto its = std::ranges::find(run.found.mutations, mutation.name, &MutationRecord::name);
      if (its == run.found.mutations.end()) continue;
      proposed += its->proposed;
      accepted += its->accepted;
      acceptance += its->mean_acceptance * static_cast<double>(its->proposed);
      jumps += its->squared_jump * static_cast<double>(its->proposed);
      longest = std::max(longest, its->longest_rejection_run);
      for (const auto& [reason, count] : its->failures) failures[reason] += count;
    }
    EXPECT_EQ(mutation.proposed, proposed);
    EXPECT_EQ(mutation.accepted, accepted);
    EXPECT_EQ(mutation.failures, failures);
    EXPECT_EQ(mutation.longest_rejection_run, longest);
    EXPECT_NEAR(mutation.mean_acceptance * static_cast<double>(proposed), acceptance, 1e-6);
    EXPECT_NEAR(mutation.squared_jump * static_cast<double>(proposed), jumps, 1e-6);
  }
  EXPECT_EQ(all.chains, runs[0].found.chains + runs[1].found.chains);
}

// As many draws again tell as much again.
TEST(MergedChains, HaveTheEffectiveSamplesOfAll) {
  const Job job = chains_job();
  const std::vector<Kept> runs{kept_run(job, 1, 300'000), kept_run(job, 2, 300'000)};
  const Rendering all = merged(job, runs);
  for (std::size_t k = 0; k < all.chains_record->functionals.size(); ++k) {
    const FunctionalRecord& f = all.chains_record->functionals[k];
    double sum = 0;
    for (const Kept& run : runs) sum += run.found.chains_record->functionals[k].ess_bulk;
    EXPECT_GT(f.ess_bulk, 0.7 * sum) << f.name;
    EXPECT_LT(f.ess_bulk, 1.4 * sum) << f.name;
    EXPECT_LT(f.r_hat, 1.2) << f.name;
  }
}

bool says(const Rendering& rendering, const std::string& text) {
  return std::ranges::any_of(rendering.warnings, [&](const std::string& warning) {
    return warning.find(text) != std::string::npos;
  });
}

// Draws that all chains have would be few.
TEST(MergedChains, ThatAreFarShorterTakeNoPartInDiagnostics) {
  const Job job = chains_job();
  const Kept longer = kept_run(job, 1, 120'000), other = kept_run(job, 3, 90'000);
  const Rendering all = merged(job, {longer, kept_run(job, 2, 6'000), other});
  EXPECT_TRUE(says(all, "are of 128 of 192 chains"));
  const Rendering alone = merged(job, {longer, other});
  EXPECT_FALSE(says(alone, " of 192 chains"));
  EXPECT_EQ(all.chains_record->draws, alone.chains_record->draws);
  EXPECT_EQ(all.chains_record->functionals[0].r_hat, alone.chains_record->functionals[0].r_hat);
  EXPECT_GT(all.chains_record->draws, 63u);
}

// Groups of one chain and of three are compared by one chain of each.
TEST(MergedChains, OfGroupsWithMoreAndFewerChainsAreJudged) {
  const Job job(mirror_and_glass(), find_method("mlt"), {.chains = {.steps_per_chain = 500}});
  const Kept few = kept_run(job, 1, 64 * 900), many = kept_run(job, 2, 64 * 1700);
  ASSERT_EQ(few.found.chains, 64);
  ASSERT_EQ(many.found.chains, 192);
  const Rendering all = merged(job, {few, many});
  EXPECT_EQ(all.chains, 256);
  EXPECT_FALSE(says(all, " of 256 chains"));
  for (const FunctionalRecord& f : all.chains_record->functionals) EXPECT_LT(f.r_hat, 2) << f.name;
}

TEST(Merging, ThatCannotReadAStateSaysSo) {
  const Job job = chains_job();
  Kept broken = kept_run(job, 1, 1'000);
  broken.state.resize(100);
  EXPECT_THROW(merged(job, {broken}), CommandFailure);
}

}  // namespace
}  // namespace wander::test::merge_test
