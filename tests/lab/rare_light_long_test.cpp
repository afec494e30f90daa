// What is claimed of pixels that seldom meet the light of a caustic: of those that are called reliable few less have the truth in their
// 95 % intervals than should have, and more than of those that a pixel's own error would choose.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

#include "lab/engine.h"
#include "lab/scene_source.h"
#include "tests/lab/sunny_room.h"
#include "tests/support/covered_bins.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace rare_light_long_test {
namespace {

constexpr int runs = 60;

FilmEstimate film_of(const description::Scene& scene, std::string_view method,
                     std::uint64_t samples, std::uint64_t seed) {
  Session session;
  session.threads = 2;
  session.seed = seed;
  session.budget = SampleBudget{samples};
  return render({scene, find_method(method)}, session).film;
}

struct Claims {
  CoveredBins of_rule, of_own;  // of pixels that are known to a tenth by their own error
};
// Whether they hold is asked with both errors.
Claims claims(FilmEstimate film, const FilmEstimate& truth) {
  std::vector<bool> known;
  for (std::size_t i = 0; i < truth.value.size(); ++i) {
    double& error = film.standard_error[i];
    known.push_back(film.value[i] >= 10 * error);
    error = std::hypot(error, truth.standard_error[i]);
  }
  const CoveredBins of_rule = covered_bins(film, truth.value, 1);
  film.reliable = known;
  return {of_rule, covered_bins(film, truth.value, 1)};
}

struct Case {
  const char* method;
  std::uint64_t samples;
};
class RareLightClaims : public ::testing::TestWithParam<Case> {};

// Other runs, beside a film of pt of 300 million samples: of 60 of mlt 0.945 of the claims held, of 30 of bdpt 0.944; these here have
// 0.941 ± 0.009 and 0.942 ± 0.007, run by run, and 0.099 ± 0.007 and 0.053 ± 0.005 less hold by a pixel's own error.  So the bounds lie five
// standard errors off and more: passed by chance once in a million.  Nine times in ten the first sees that 0.88 hold; a rule that
// is no better than a pixel's own error gains nothing; one that gives up a third of the claims of mlt, or a half of those of bdpt, is seen.
TEST_P(RareLightClaims, Hold) {
  const description::Scene scene = parse_scene(sunny_room, "room").scene;
  const FilmEstimate truth = film_of(scene, "pt", 60'000'000, 4711);
  Moments of_rule, gained;
  double claimed = 0;
  for (int run = 0; run < runs; ++run) {
    const auto seed = 1000 + static_cast<std::uint64_t>(run);
    const Claims of_run =
        claims(film_of(scene, GetParam().method, GetParam().samples, seed), truth);
    if (of_run.of_rule.reliable == 0 || of_run.of_own.reliable == 0) continue;
    claimed += of_run.of_rule.reliable / static_cast<double>(truth.value.size()) / runs;
    of_rule.add(of_run.of_rule.share());
    gained.add(of_run.of_rule.share() - of_run.of_own.share());
  }
  std::cout << of_rule.mean() << " ± " << of_rule.standard_error() << " of " << claimed
            << " hold, gained " << gained.mean() << " ± " << gained.standard_error() << "\n";
  EXPECT_GT(claimed, 0.4);
  EXPECT_GT(of_rule.mean(), 0.89);
  EXPECT_GT(gained.mean(), 0);
}
INSTANTIATE_TEST_SUITE_P(SunnyRoom, RareLightClaims,
                         ::testing::Values(Case{"mlt", 250'000}, Case{"bdpt", 2'000'000}));

}  // namespace
}  // namespace rare_light_long_test
}  // namespace wander::test
