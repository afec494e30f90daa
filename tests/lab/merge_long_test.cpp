// 8 merged runs of n samples are as good as one of 8 n: their 95 % t-intervals cover the exact film
// in 93 to 97 % of the reliable bins, and their error is that of the long run.  60 seeds; false alarm
// 1e-7 beyond that, from the spread of the coverage over seeds.  Controls: error bars that are 30 %
// too short, and a run that is merged with itself, as `merge` refuses to do.
#include <gtest/gtest.h>

#include <sstream>

#include "core/exact/diffuse_film.h"
#include "core/film_statistics.h"
#include "lab/engine.h"
#include "scenes/format/scene_file.h"
#include "tests/support/covered_bins.h"
#include "tests/support/expect.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

constexpr int seeds = 60;
constexpr std::uint64_t parts = 8;

struct Case {
  const char* scene;
  const char* method;
  std::uint64_t samples;  // of the shortest part
  std::uint64_t growth;   // the last part has so many times as many
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.scene << ' ' << c.method << ' ' << parts << " x " << c.samples << " to "
             << c.growth * c.samples;
}

double square_error(const FilmEstimate& film, const std::vector<double>& exact) {
  double sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) sum += std::pow(film.value[i] - exact[i], 2);
  return sum;
}

std::string state_of_run(const Job& job, std::uint64_t seed, std::uint64_t samples) {
  Session session;
  session.budget = SampleBudget{samples};
  session.seed = seed;
  std::string state;
  const Keeper keeper{[&](const Headway&, const StateWriter& write) {
                        std::ostringstream bytes;
                        write(bytes);
                        state = bytes.str();
                      },
                      0, 0};
  carry_on({}, job, session, keeper);
  return state;
}

class MergedCoverage : public ::testing::TestWithParam<Case> {};

TEST_P(MergedCoverage, IsThatOfOneRun) {
  const Case c = GetParam();
  const SceneDocument document =
      read_scene_file(std::string(WANDER_SOURCE) + "/scenes/" + c.scene + ".json");
  const Job job(document.scene, find_method(c.method));
  const std::vector<double> exact = exact::diffuse_film(document.scene).value;
  Moments honest, too_short, twins, of_merged, of_one;
  double reliable = 0;
  for (std::uint64_t k = 0; k < seeds; ++k) {
    std::vector<StoredRun> runs;
    std::uint64_t samples = 0;
    for (std::uint64_t p = 0; p < parts; ++p) {
      const std::uint64_t seed = 1000 * (k + 1) + p;
      const std::uint64_t count = c.samples * (1 + (c.growth - 1) * p / (parts - 1));
      samples += count;
      runs.push_back({seed, [state = state_of_run(job, seed, count)] { return state; }, "none"});
    }
    const Session session;
    const FilmEstimate film = merge(job, runs, session).film;
    honest.add(covered_bins(film, exact, 1).share());
    too_short.add(covered_bins(film, exact, 0.7).share());
    of_merged.add(square_error(film, exact));
    reliable +=
        static_cast<double>(reliable_bins(film)) / static_cast<double>(exact.size()) / seeds;
    const std::vector<StoredRun> same(parts, runs.back());
    twins.add(covered_bins(merge(job, same, session).film, exact, 1).share());
    Session one;
    one.budget = SampleBudget{samples};
    one.seed = 1000 * (k + 1) + parts;
    of_one.add(square_error(render(job, one).film, exact));
  }
  const double z = sidak_threshold(usual_false_alarm, 1);
  const double ratio = of_merged.mean() / of_one.mean();
  const double ratio_error = ratio * std::hypot(of_merged.standard_error() / of_merged.mean(),
                                                of_one.standard_error() / of_one.mean());
  std::cout << c << ": covered " << honest.mean() << " ± " << honest.standard_error() << " of "
            << reliable << " reliable; square error over that of one run " << ratio << " ± "
            << ratio_error << "; with itself " << twins.mean() << '\n';
  EXPECT_GT(reliable, 0.5);
  EXPECT_NEAR(honest.mean(), 0.95, 0.02 + z * honest.standard_error());
  EXPECT_LT(too_short.mean(), honest.mean() - 0.05);
  EXPECT_LT(twins.mean(), 0.8);
  EXPECT_LT(ratio, 1 + z * ratio_error);
}
INSTANTIATE_TEST_SUITE_P(Films, MergedCoverage,
                         ::testing::Values(Case{"article-2", "bdpt", 20'000, 1},
                                           Case{"article-2", "mlt", 20'000, 1},
                                           Case{"article-3", "mlt", 20'000, 1},
                                           Case{"article-3", "mlt", 20'000, 10}));

}  // namespace
}  // namespace wander::test
