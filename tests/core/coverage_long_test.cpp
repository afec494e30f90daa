// The error bars hold what they promise: 95 % t-intervals cover the exact film in 95 % of the bins
// that a run calls reliable, for every method.
//
// Exact films: radiosity.  Bins of one run are correlated, so the spread of the coverage is taken
// from the runs themselves; false alarm 1e-7 per comparison.  Control: error bars that are 30 % too
// short must be caught.
#include <gtest/gtest.h>

#include "core/exact/radiosity.h"
#include "lab/engine.h"
#include "scenes/format/scene_file.h"
#include "tests/support/covered_bins.h"
#include "tests/support/expect.h"
#include "tests/support/statistics.h"

namespace wander::test {

using namespace exact;
namespace {

constexpr int runs = 160;
// What skewed sums may cost: the promise is 93 to 97 %.
constexpr double tolerance = 0.02;

struct Case {
  const char* scene;
  const char* method;
  std::uint64_t samples;
  FilmLayout film{};
};
// As films of more than 2^14 bins are kept.
constexpr FilmLayout large{.most_small = 16};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.scene << ' ' << c.method << (c.film == large ? " (large)" : "");
}

// Share of covered bins among the reliable ones, by run; error bars are scaled by `scale`.
struct Coverage {
  Moments all;          // of the share of a run
  double reliable = 0;  // share of bins

  void add(const FilmEstimate& film, const std::vector<double>& exact, double scale) {
    const CoveredBins bins = covered_bins(film, exact, scale);
    reliable += bins.reliable / static_cast<double>(exact.size()) / runs;
    if (bins.reliable > 0) all.add(bins.share());
  }
};

class Coverages : public ::testing::TestWithParam<Case> {};

TEST_P(Coverages, OfTheNinetyFivePercentIntervalsAreWhatTheyPromise) {
  const Case c = GetParam();
  const std::string path = std::string(WANDER_SOURCE) + "/scenes/" + c.scene + ".json";
  const SceneDocument document = read_scene_file(path);
  const auto exact = solve_radiosity(radiosity_scene(document.scene)).film().mean_irradiance;
  Coverage honest, short_by_a_third;
  for (int run = 0; run < runs; ++run) {
    Session session;
    session.budget = SampleBudget{c.samples};
    session.seed = 1000 + static_cast<std::uint64_t>(run);
    const Job job(document.scene, find_method(c.method), {.film = c.film});
    const FilmEstimate film = render(job, session).film;
    honest.add(film, exact, 1);
    short_by_a_third.add(film, exact, 0.7);
  }
  const double z = sidak_threshold(usual_false_alarm, 1);
  const double spread = z * honest.all.standard_error();
  std::cout << c << ": " << honest.all.mean() << " ± " << honest.all.standard_error() << " of "
            << honest.reliable << " reliable\n";
  EXPECT_GT(honest.reliable, 0.5);
  EXPECT_NEAR(honest.all.mean(), 0.95, tolerance + spread);
  EXPECT_LT(short_by_a_third.all.mean(), honest.all.mean() - 0.05);
}
INSTANTIATE_TEST_SUITE_P(
    Films, Coverages,
    ::testing::Values(Case{"article-1", "pt", 50'000}, Case{"article-1", "lt", 50'000},
                      Case{"article-1", "bdpt", 50'000}, Case{"article-1", "pt-naive", 100'000},
                      Case{"article-1", "lt-naive", 100'000}, Case{"article-1", "mlt", 200'000},
                      Case{"article-2", "bdpt", 100'000}, Case{"article-2", "mlt", 400'000},
                      Case{"article-3", "bdpt", 1'500'000}, Case{"article-3", "mlt", 1'000'000},
                      Case{"slit", "lt", 1'500'000}, Case{"slit", "bdpt", 1'500'000},
                      Case{"slit", "mlt", 1'500'000}, Case{"article-1", "bdpt", 50'000, large},
                      Case{"article-1", "mlt", 200'000, large},
                      Case{"article-1", "pssmlt", 200'000, large},
                      Case{"article-1", "mmlt", 200'000, large},
                      Case{"article-3", "mlt", 1'000'000, large}));

}  // namespace
}  // namespace wander::test
