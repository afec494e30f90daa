// The report at the edges of what can be measured: nothing, one of each, very many, films without
// light or numbers, estimates that failed.
#include <gtest/gtest.h>

#include "draw/report/report.h"
#include "tests/draw/report/comparison_maker.h"
#include "tests/draw/report/report_checks.h"

namespace wander {
namespace {

using compare::Comparison;

const Comparison& of_chains() {
  static const Comparison made = test::make_comparison(
      {"gallery:glass-caustic-camera", {"mlt", "pssmlt", "mmlt"}, {20'000}, 2});
  return made;
}

std::string report_of(const compare::Runs& runs) { return report_html(compare::summarize(runs)); }

bool says(const std::string& html, const std::string& words) {
  return html.find(words) != std::string::npos;
}

TEST(ReportExtremes, IsSoundForOneOfEachAndForManyBins) {
  const std::string one =
      report_html(test::make_comparison({"gallery:article-1", {"mlt"}, {10'000}, 1}));
  test::expect_sound(one);
  EXPECT_TRUE(says(one, "it takes at least two replicates"));
  EXPECT_TRUE(says(one, "One budget has no slope"));
  test::expect_sound(report_html(test::with_bins(test::usual(), 1)));
  test::expect_sound(report_html(test::with_bins(test::usual(), 1000)));
}

TEST(ReportExtremes, IsSoundWithoutReferenceOrDetailsOrRuns) {
  Comparison unmeasured = test::usual();
  unmeasured.runs.reference = {};
  test::expect_sound(report_html(unmeasured));
  compare::Runs runs = test::usual().runs;
  runs.details.clear();
  runs.complete = false;
  runs.runs.resize(3);
  const std::string html = report_of(runs);
  test::expect_sound(html);
  EXPECT_TRUE(says(html, "was interrupted"));
  EXPECT_TRUE(says(html, "there are no films to show"));
  runs.runs.clear();
  test::expect_sound(report_of(runs));
}

TEST(ReportExtremes, IsSoundForFilmsWithoutLightOrNumbers) {
  compare::Runs runs = test::usual().runs;
  for (const double value : {0.0, not_known, 1e300, 1e-300}) {
    const auto fill = [&](FilmEstimate& film) {
      std::ranges::fill(film.value, value);
      std::ranges::fill(film.standard_error, value);
    };
    for (compare::Run& run : runs.runs) fill(run.film);
    for (Rendering& details : runs.details) fill(details.film);
    if (value == 0) test::expect_sound(report_of(runs));
    fill(runs.reference.film);
    test::expect_sound(report_of(runs));
  }
}

TEST(ReportExtremes, SaysThatANormalizationHasFailedOrDisagrees) {
  compare::Runs runs = of_chains().runs;
  Normalization& b = *runs.details.front().normalization;
  b.estimates["bridge"] = {{not_known, not_known}, 0};
  b.estimates["least_squares"] = {{2 * b.value, 0.01 * b.value}, 1000};
  const std::string html = report_of(runs);
  test::expect_sound(html);
  EXPECT_TRUE(says(html, "Failed, and not used: bridge of mlt."));
  EXPECT_TRUE(says(html, "estimates disagree: least squares and pooled of mlt"));
  EXPECT_FALSE(says(report_html(of_chains()), "estimates disagree"));
}

}  // namespace
}  // namespace wander
