// Films of pssmlt and mmlt, with both estimators, are exact where the film is known; each length by
// itself in a furnace; and without bias for the shortest of seed passes and of chains.
//
// False alarms: 1e-9 per film or per mean of films.
#include <gtest/gtest.h>

#include <cmath>

#include "core/exact/radiosity.h"
#include "lab/estimate.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/primary_runs.h"
#include "tests/support/reference_values.h"
#include "tests/support/test_scenes.h"

namespace wander::test::primary_films_test {

using namespace exact;
namespace {

class PrimaryFilms : public ::testing::TestWithParam<PrimaryMethod> {
 protected:
  Rendering render(const Scene<Flatland>& scene, std::uint64_t samples,
                   std::uint64_t seed = 1) const {
    return GetParam().render(scene, budget_of(samples, seed), {});
  }
};
INSTANTIATE_TEST_SUITE_P(Methods, PrimaryFilms, ::testing::ValuesIn(primary_methods),
                         [](const auto& test) { return std::string(test.param.name); });

FilmEstimate exact_film(std::vector<double> values) {
  FilmEstimate film;
  film.standard_error.resize(values.size());
  film.reliable.assign(values.size(), true);
  film.value = std::move(values);
  film.degrees_of_freedom = 1;  // of no weight: the error is zero
  return film;
}
void expect_exact(const Rendering& rendering, const std::vector<double>& values) {
  const Decision decision = films_agree(rendering.film, exact_film(values), usual_false_alarm);
  EXPECT_TRUE(passes(decision));
  EXPECT_EQ(decision.comparisons, values.size());
  std::vector<double> wrong = values;  // control
  for (double& value : wrong) value *= 1.3;
  EXPECT_TRUE(rejects(films_agree(rendering.film, exact_film(wrong), usual_false_alarm)));
}

SceneMaker blocked_light() {
  namespace scene = reference::blocker;
  SceneMaker maker(4);
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::obstacle);
  maker.line(scene::sensor, {.bins = 8});
  return maker;
}
std::vector<double> blocked_film() {
  return {reference::blocker::film.begin(), reference::blocker::film.end()};
}

TEST_P(PrimaryFilms, OfAParallelEmitterAndBehindABlockerAreExact) {
  namespace scene = reference::parallel_emitter;
  SceneMaker maker(3);
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::sensor, {.bins = 4});
  expect_exact(render(*maker.build(), 60'000), {scene::film.begin(), scene::film.end()});
  expect_exact(render(*blocked_light().build(), 100'000), blocked_film());
}

TEST_P(PrimaryFilms, OfDiffuseRoomsAreThoseOfRadiosity) {
  const SceneMaker maker = open_room(5);
  const RadiositySolution exact = solve_radiosity(radiosity_scene(maker.description()));
  expect_exact(render(*maker.build(), 80'000), exact.film().mean_irradiance);
}

TEST_P(PrimaryFilms, AreThoseOfIndependentSamples) {
  for (const auto& make : {&mirror_and_glass, &rough_room, &pinhole_room}) {
    description::Scene description = make();
    description.max_vertices = 5;
    const FlatScene scene = build(description);
    Rendering samples;
    for (const Estimator& estimator : estimators())
      if (std::string_view(estimator.name) == "bdpt")
        samples = estimate(*scene, estimator, budget_of(400'000, 2));
    const Decision agree =
        films_agree(render(*scene, 40'000).film, samples.film, usual_false_alarm);
    EXPECT_TRUE(passes(agree));
    EXPECT_GE(agree.comparisons, std::size_t{3});
  }
}

// ---- each length by itself

// All walls emit and reflect: paths of n vertices carry 2 Le ρ^(n-2), everywhere.
constexpr double radiance = 1.5, reflectance = 0.6;
constexpr int longest = 5;
double furnace_light(int vertices) { return 2 * radiance * std::pow(reflectance, vertices - 2); }

SceneMaker furnace() {
  SceneMaker maker(longest);
  const std::size_t wall = maker.diffuse(reflectance);
  const std::vector<PlanePoint> corners{{0, 0}, {2, 0}, {2, 1}, {0.9, 1.4}, {-0.3, 0.9}};
  for (std::size_t i = 0; i < corners.size(); ++i)
    maker.segment(corners[i], corners[(i + 1) % corners.size()], {wall, radiance, i == 2 ? 2 : 0});
  return maker;
}

using Renderer = decltype(PrimaryMethod::render);

Decision furnace_lengths(Renderer render) {
  const auto scene = furnace().build();
  const ChainSettings settings{
      .groups = 16, .fewest_seeds = 1024, .normalization = NormalizationMethod::seed_pass};
  std::map<int, std::vector<Moments>> runs;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Rendering r = render(*scene, budget_of(4000, seed), settings);
    for (const auto& [vertices, film] : r.film.by_length) {
      auto& bins = runs[vertices];
      bins.resize(film.size());
      for (std::size_t i = 0; i < film.size(); ++i) bins[i].add(film[i]);
    }
  }
  Decision worst{.test = "lengths of a furnace", .passed = true};
  const double each = sidak_rate(usual_false_alarm, 2 * (longest - 1));
  for (int n = 2; n <= longest; ++n)
    for (const Moments& bin : runs[n]) {
      const Decision decision = t_test(bin, furnace_light(n), each);
      if (decision.p_value <= worst.p_value) worst = decision;
    }
  return worst;
}

TEST_P(PrimaryFilms, OfEachLengthInAFurnaceAreExact) {
  EXPECT_TRUE(passes(furnace_lengths(GetParam().render)));
}

// A twin in which the paths of two and of three vertices have each other's constant.
struct SwappedConstants {
  static constexpr bool needs_seed = true;

  template <class Sample>
  static PrimaryDeposit deposit(const PrimaryStep<Sample>& step, PrimaryConstants b) {
    const int n = step.current.path.size();
    b.own *= n == 2 ? reflectance : n == 3 ? 1 / reflectance : 1;
    return ExpectedValues::deposit(step, b);
  }
};
TEST(PrimaryTwin, OfMmltWithTheConstantsOfOtherLengthsIsCaught) {
  EXPECT_TRUE(rejects(furnace_lengths(&render_primary<MmltGroup, SwappedConstants>)));
}

// ---- bias

struct Effort {
  std::uint64_t runs, seeds, steps;  // each run has 32 groups
};
// One seed sample in each group, so that most are dark, and three steps.
constexpr Effort hardly_any{1000, 32, 96};

// The mean of many runs.
Decision mean_of_runs(Renderer render, Effort effort) {
  const auto scene = blocked_light().build();
  const std::vector<double> exact = blocked_film();
  const ChainSettings settings{.groups = 32,
                               .chains_per_group = 1,
                               .seed_share = 0,
                               .fewest_seeds = effort.seeds,
                               .normalization = NormalizationMethod::seed_pass};
  double mean = 0;
  for (const double value : exact) mean += value / static_cast<double>(exact.size());
  Moments total, left;  // the mean of the film, and its first bin
  for (std::uint64_t seed = 1; seed <= effort.runs; ++seed) {
    Session session = budget_of(effort.steps, seed);
    session.threads = 1;
    const Rendering r = render(*scene, session, settings);
    double sum = 0;
    for (const double value : r.film.value) sum += value / static_cast<double>(exact.size());
    total.add(sum);
    left.add(r.film.value[0]);
  }
  const double each = sidak_rate(usual_false_alarm, 2);
  const Decision whole = t_test(total, mean, each), bin = t_test(left, exact[0], each);
  return whole.p_value < bin.p_value ? whole : bin;
}

TEST_P(PrimaryFilms, HaveNoBiasHoweverShortTheirRuns) {
  EXPECT_TRUE(passes(mean_of_runs(GetParam().render, hardly_any)));
}

// A twin whose dark groups take no large steps, as if they had nothing to say.
struct SilentInTheDark : KelemenWeights {
  static constexpr bool needs_seed = true;
};
// A twin that counts a large step only if it is accepted.
struct AcceptedOnly : KelemenWeights {
  template <class Sample>
  static PrimaryDeposit deposit(const PrimaryStep<Sample>& step, const PrimaryConstants& b) {
    const PrimaryDeposit whole = KelemenWeights::deposit(step, b);
    if (step.accepted() || step.move == PrimaryMove::small) return whole;
    const double metropolis = b.own * step.acceptance;
    return {whole.current, whole.proposed * metropolis / (metropolis + b.others)};
  }
};
TEST(PrimaryTwin, OfKelemensWeightsThatLeavesOutSomeLargeStepsIsCaught) {
  constexpr Effort longer{60, 4096, 8000}, more_runs{1500, 32, 96};
  EXPECT_TRUE(rejects(mean_of_runs(&render_primary<PssmltGroup, SilentInTheDark>, more_runs)));
  EXPECT_TRUE(rejects(mean_of_runs(&render_primary<MmltGroup, SilentInTheDark>, more_runs)));
  EXPECT_TRUE(passes(mean_of_runs(&render_primary<PssmltGroup, KelemenWeights>, longer)));
  EXPECT_TRUE(rejects(mean_of_runs(&render_primary<PssmltGroup, AcceptedOnly>, longer)));
}

}  // namespace
}  // namespace wander::test::primary_films_test
