// A comparison whose films lie on a shelf is the one whose films are in memory; and few are lent at
// a time.
#include "lab/compare/film_loan.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "lab/compare/comparison_json.h"
#include "lab/compare/film_files.h"
#include "tests/support/images.h"

namespace wander::test::film_loan_test {
namespace {

using namespace compare;

constexpr std::size_t replicates = 4;

Runs image_runs() {
  Runs runs;
  runs.budgets = {"1s", "2s"};
  runs.replicates = replicates;
  runs.provenance.dimension = 3;
  runs.contenders = {{"mlt", "mlt"}, {"bdpt", "bdpt"}};
  runs.reference.film = image_run(10, 6, 3, 99).rendering.film;
  std::uint64_t seed = 0;
  for (std::size_t r = 0; r < replicates; ++r)
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t c = 0; c < 2; ++c) {
        const Rendering made = image_run(10, 6, 3, ++seed).rendering;
        runs.runs.push_back(
            {c, b, r, seed, 1000 * (b + 1), 1. + static_cast<double>(b), 0, 0, made.film});
      }
  return runs;
}

TEST(FilmLoan, AComparisonFromTheShelfIsTheSame) {
  const Runs plain = image_runs();
  Runs shelved = plain;
  std::map<std::uint64_t, FilmEstimate> shelf;
  for (compare::Run& run : shelved.runs) {
    shelf[run.seed] = run.film;
    shelve(run.film);
  }
  shelved.shelf = [&](const compare::Run& run) { return shelf.at(run.seed); };
  const Comparison one = summarize(plain), other = summarize(shelved);
  EXPECT_EQ(to_json(one).dump(), to_json(other).dump());
  EXPECT_GT(one.cells.at(0).rmse.value, 0);
  for (const compare::Run& run : other.runs.runs) {
    EXPECT_TRUE(run.film.value.empty());
    EXPECT_EQ(run.film.shape, (std::vector<int>{6, 10, 3}));
    EXPECT_EQ(film_of(other.runs, run).value, shelf.at(run.seed).value);
  }
}

// What is lent is back before the next cell's films are taken.
TEST(FilmLoan, NoMoreFilmsThanThoseOfACellAreInMemory) {
  Runs runs = image_runs();
  const FilmEstimate any = runs.runs.front().film;
  for (compare::Run& run : runs.runs) shelve(run.film);
  std::size_t taken = 0;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // cells, as their films were taken
  runs.shelf = [&](const compare::Run& run) {
    ++taken;
    if (order.empty() || order.back() != std::pair(run.contender, run.budget))
      order.emplace_back(run.contender, run.budget);
    return any;
  };
  const Comparison made = summarize(runs);
  EXPECT_EQ(taken, 4 * replicates);
  EXPECT_EQ(order.size(), 4u);
}

TEST(FilmLoan, ALoanEndsWithItsLife) {
  Runs runs = image_runs();
  const FilmEstimate film = runs.runs[1].film;
  shelve(runs.runs[1].film);
  {
    const FilmLoan loan([&](const compare::Run&) { return film; }, {&runs.runs[0], &runs.runs[1]});
    EXPECT_EQ(runs.runs[1].film.value, film.value);
  }
  EXPECT_TRUE(runs.runs[1].film.value.empty());
  EXPECT_FALSE(runs.runs[0].film.value.empty());  // its own
}

TEST(FilmFiles, NamesAreOfContenderAndBudgetAndNoTwoAlike) {
  Runs runs;
  runs.budgets = {"30s", "2 min"};
  runs.contenders = {{"mlt large_step=0.3 (default)", "mlt"}, {"bdpt", "bdpt"}, {"bdpt ", "bdpt"}};
  EXPECT_EQ(film_file(runs, 0, 0), "films/mlt-large_step=0.3-default-30s.exr");
  EXPECT_EQ(film_file(runs, 1, 1), "films/bdpt-2-min.exr");
  EXPECT_EQ(film_file(runs, 2, 1), "films/bdpt-2-min-2.exr");
  EXPECT_EQ(shown_run(runs, 0, 0), nullptr);
  runs.runs.resize(2);
  for (compare::Run& run : runs.runs) run.contender = 1;
  runs.runs[0].replicate = 1;
  EXPECT_EQ(shown_run(runs, 1, 0), &runs.runs[1]);
}

}  // namespace
}  // namespace wander::test::film_loan_test
