// Chains whose target is f v, with a factor v of each bin: b and the light of each length are those of f, by all that
// estimate them.  Against the exact film.
//
// False alarms: 1e-9 for each number.  Standard errors are asked to be small enough that each number would show an error of
// an eighth, too large or too small; of a length, one of a quarter of b.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "core/exact/radiosity.h"
#include "mlt/run/chain_settings.h"
#include "mlt/run/normalization.h"
#include "mlt/run/path_group.h"
#include "mlt/run/pooled_film.h"
#include "mutations/catalogue.h"
#include "tests/mlt/run/octaves.h"
#include "tests/support/core_scenes.h"
#include "tests/support/statistics.h"

namespace wander::test::uneven_target_test {
namespace {

using Flat = Transport<Flatland>;
using Group = PathGroup<Flat, Family>;

constexpr int groups = 64, max_vertices = 5;
constexpr double most_errors = 6.5, shown = 0.125;  // a normal number is beyond 6.1 once in 1e9

class UnevenRun {
 public:
  explicit UnevenRun(const ImportanceMap* importance)
      : space_(importance ? plain_.measuring(*importance) : plain_) {
    for (int g = 0; g < groups; ++g) {
      Group& group = *groups_.emplace_back(std::make_unique<Group>(space_, kernel_, 5, g, 2));
      group.divide({{exact_b()}});
      group.add_seeds(2000);
      all_.merge(group.tally());
    }
    for (const auto& group : groups_) {
      group->end_seeds();
      group->start_chains(all_);
      if (group->takes_steps()) group->advance(6000);
    }
  }

  std::vector<GroupFindings> findings() const {
    std::vector<GroupFindings> found;
    for (const auto& group : groups_) found.push_back(group->findings());
    return found;
  }
  std::vector<double> exact_film() const {
    return exact::solve_radiosity(exact::radiosity_scene(room_.description()))
        .film()
        .mean_irradiance;
  }
  double exact_b() const {
    const std::vector<double> film = exact_film();
    return std::accumulate(film.begin(), film.end(), 0.0) / static_cast<double>(film.size());
  }

 private:
  SceneMaker room_ = open_room(max_vertices);
  decltype(room_.build()) scene_ = room_.build();
  Flat plain_{*scene_, Roulette::off};
  Flat space_;
  Family kernel_ = make_family({}, max_vertices);
  std::vector<std::unique_ptr<Group>> groups_;
  SeedTally all_{max_vertices};
};

bool is_right(const Estimate& estimate, double exact) {
  EXPECT_LT(most_errors * estimate.standard_error, shown * exact) << "no power";
  return std::abs(estimate.value - exact) <= most_errors * estimate.standard_error;
}

ImportanceMap uneven() { return {Raster(4), {0.25, 4, 1, 8}}; }

TEST(UnevenTargets, KnowB) {
  const ImportanceMap importance = uneven();
  const UnevenRun run(&importance);
  const std::vector<GroupFindings> found = run.findings();
  Constants b = constants(found);
  b.pooled = pooled_constant(found, std::array{groups});
  for (const auto method : {NormalizationMethod::seed_pass, NormalizationMethod::least_squares,
                            NormalizationMethod::bridge, NormalizationMethod::pooled})
    EXPECT_TRUE(is_right(b[method].b, run.exact_b()))
        << name_of(method) << " " << b[method].b.value;
  EXPECT_LT(largest_difference(found, 0), most_errors);
}

TEST(UnevenTargets, KnowTheLightOfEachLengthAndBin) {
  const ImportanceMap importance = uneven();
  const UnevenRun run(&importance), of_light(nullptr);
  const std::vector<GroupFindings> found = run.findings(), other = of_light.findings();
  for (const auto method : {NormalizationMethod::seed_pass, NormalizationMethod::bridge}) {
    const auto record = normalization(found, constants(found), method).by_length,
               expected = normalization(other, constants(other), method).by_length;
    ASSERT_EQ(record.size(), expected.size());
    for (std::size_t k = 0; k < record.size(); ++k) {
      const double error = std::hypot(record[k].standard_error, expected[k].standard_error);
      EXPECT_LT(std::abs(record[k].value - expected[k].value), most_errors * error) << k;
      EXPECT_LT(most_errors * error, 2 * shown * run.exact_b()) << "no power";
    }
  }
  const std::vector<double> exact = run.exact_film();
  const PooledFilm pooled = pooled_film(found, std::array{groups}, constants(found).bridge,
                                        {static_cast<int>(exact.size())});
  for (std::size_t j = 0; j < exact.size(); ++j)
    EXPECT_TRUE(is_right({pooled.film.value[j], pooled.film.standard_error[j]}, exact[j])) << j;
}

// All classes together.
TEST(UnevenTargets, KnowTheLightOfClasses) {
  const ImportanceMap importance = uneven();
  const UnevenRun run(&importance);
  Moments light;
  for (const GroupFindings& group : run.findings()) {
    const ClassParts& classes = group.parts.front().classes();
    double of_group = 0;
    for (std::size_t c = 0; c < classes.size(); ++c) of_group += group.scale * classes.states(c);
    light.add(of_group);
  }
  EXPECT_TRUE(is_right({light.mean(), light.standard_error()}, run.exact_b()));
}

// States of f v held against paths of f.  The bridge sees that they do not agree, and leans on the paths.
TEST(UnevenTargets, ThatAreComparedWithSamplesOfLightAreCaught) {
  const ImportanceMap importance = uneven();
  const UnevenRun run(&importance), of_light(nullptr);
  std::vector<GroupFindings> found = run.findings();
  const std::vector<GroupFindings> other = of_light.findings();
  for (std::size_t g = 0; g < found.size(); ++g) found[g].evidence = other[g].evidence;
  EXPECT_GT(largest_difference(found, 0), 2 * most_errors);
  EXPECT_TRUE(is_right(constants(found).bridge.b, run.exact_b()));
}

}  // namespace
}  // namespace wander::test::uneven_target_test
