#include "tests/support/claimed_errors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

#include "lab/engine.h"
#include "scenes/format/scene_file.h"
#include "statistics/jackknife.h"
#include "statistics/visible_error.h"
#include "tests/support/expect.h"

namespace wander::test {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Variance over runs, but for one, over the mean of what they claim.
double spread_over_claim(const std::vector<FilmEstimate>& films, std::size_t bin,
                         std::size_t left_out) {
  double n = 0, sum = 0, squares = 0, claimed = 0;
  const double level = films.front().value[bin];
  for (std::size_t r = 0; r < films.size(); ++r) {
    if (r == left_out) continue;
    const double x = films[r].value[bin] - level, error = films[r].standard_error[bin];
    ++n;
    sum += x;
    squares += x * x;
    claimed += error * error;
  }
  return (squares - sum * sum / n) / (n - 1) / (claimed / n);
}

std::vector<std::size_t> bins_that_all_found(const std::vector<FilmEstimate>& films) {
  std::vector<std::size_t> bins;
  for (std::size_t j = 0; j < films.front().value.size(); ++j)
    if (std::ranges::all_of(films, [&](const FilmEstimate& film) {
          return film.value[j] > 0 && film.standard_error[j] > 0;
        }))
      bins.push_back(j);
  return bins;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const RunsOfAMethod& c) {
  return out << c.scene << ' ' << c.method << (c.parts == FilmParts::chains ? " (chains)" : "");
}

std::vector<FilmEstimate> films_of(const RunsOfAMethod& c) {
  const SceneDocument document =
      read_scene_file(std::string(WANDER_SOURCE) + "/scenes/" + c.scene + ".json");
  Dials dials;
  dials.chains.film_parts = c.parts;
  const Job job(document.scene, find_method(c.method), dials);
  std::vector<FilmEstimate> films;
  for (int run = 0; run < c.runs; ++run) {
    Session session;
    session.budget = SampleBudget{c.samples};
    session.seed = 100 + static_cast<std::uint64_t>(run);
    films.push_back(render(job, session).film);
  }
  return films;
}

ClaimedRatio claimed_ratio(const std::vector<FilmEstimate>& films) {
  const std::vector<std::size_t> bins = bins_that_all_found(films);
  const auto ratio = [&](std::size_t left_out) {
    double sum = 0;
    for (const std::size_t j : bins) sum += spread_over_claim(films, j, left_out);
    return static_cast<double>(bins.size()) / sum;
  };
  std::vector<double> without;
  for (std::size_t r = 0; r < films.size(); ++r) without.push_back(ratio(r));
  return {ratio(none), jackknife_error(without), bins.size()};
}

Decision claimed_ratio_test(const ClaimedRatio& ratio, double tolerance, double false_alarm) {
  Decision d{.test = "claimed variances", .false_alarm = false_alarm};
  const double off = ratio.value - 1;
  d.threshold = sidak_threshold(false_alarm, 1);
  d.statistic = standardized(std::copysign(std::max(0.0, std::abs(off) - tolerance), off),
                             ratio.standard_error);
  d.p_value = normal_two_sided_p(d.statistic);
  d.passed = std::abs(off) <= tolerance + d.threshold * ratio.standard_error;
  d.visible = tolerance + visible_normal(ratio.standard_error, d.threshold);
  d.detail = fmt::format("ratio {} ± {}", ratio.value, ratio.standard_error);
  return d;
}

void expect_true_claims(const RunsOfAMethod& c, double tolerance) {
  const ClaimedRatio ratio = claimed_ratio(films_of(c));
  std::printf("  claimed variance over that of %d runs: %.3f ± %.3f, %zu bins\n", c.runs,
              ratio.value, ratio.standard_error, ratio.bins);
  ASSERT_GE(ratio.bins, 16u);
  EXPECT_TRUE(passes(claimed_ratio_test(ratio, tolerance, usual_false_alarm)));
}

}  // namespace wander::test
