// The techniques (s,t) of a path: what is stored with it is what evaluation from scratch gives, the
// weights of multiple importance sampling add up to one and are those of the densities, and nothing
// is ever connected at a specular vertex.
#include "core/techniques.h"

#include <gtest/gtest.h>

#include "core/path_sides.h"
#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"

namespace wander::test {
namespace {

using Space = Transport<Flatland>;

SceneMaker seen_by_lens(int max_vertices) {
  SceneMaker room(max_vertices);
  const std::size_t plaster = room.diffuse(0.7);
  description::Camera camera;
  camera.position = {0.3, 0.2, 0};
  camera.target = {1.2, 0.6, 0};
  camera.fov_degrees = 70;
  camera.resolution = {4};
  camera.aperture_radius = 0.05;
  room.camera(camera).room({{0, 0}, {2, 0}, {2, 1}, {0, 1.1}}, {plaster, 0.5});
  room.circle({1.2, 0.6}, 0.2, {room.glass(1.5)})
      .segment({1.7, 0.3}, {1.8, 0.8}, {room.rough_metal(0.1, 0.8)});
  return room;
}

struct Case {
  const char* name;
  SceneMaker (*make)(int);
  Roulette roulette;
};

class Techniques : public ::testing::TestWithParam<Case> {
 public:
  // Calls f(transport, path, s) for the paths of many samples of all techniques.
  template <class F>
  static void for_each_path(int samples, F&& f) {
    const auto scene = GetParam().make(7).build();
    const Space space(*scene, GetParam().roulette);
    PathSampler<Space> sampler(space, all_techniques, Heuristic::balance);
    Rng rng(1, Purpose::test, 0);
    int paths = 0;
    for (int i = 0; i < samples; ++i) {
      rng.start(static_cast<std::uint64_t>(i));
      sampler.sample(rng, [&](const Path<Flatland>& x, int s, double) {
        f(space, x, s);
        ++paths;
      });
    }
    EXPECT_GT(paths, samples);
  }

  // w_s = p_s^β / Σ p^β, each density a product of its own, in long double where it cannot vanish.
  static std::vector<long double> weights(const Space& space, const Path<Flatland>& x,
                                          const TechniqueSet& set, int power) {
    std::vector<long double> p;
    for (int s = 0; s <= x.size(); ++s) {
      long double density = can_sample(space, x, s, set) ? 1 : 0;
      for (int i = 0; i < x.size(); ++i) density *= i < s ? x[i].from_light : x[i].from_sensor;
      p.push_back(std::pow(density, static_cast<long double>(power)));
    }
    const long double sum = std::accumulate(p.begin(), p.end(), 0.0L);
    for (auto& w : p) w /= sum;
    return p;
  }
};
INSTANTIATE_TEST_SUITE_P(Scenes, Techniques,
                         ::testing::Values(Case{"full", &full_room, Roulette::off},
                                           Case{"full_with_roulette", &full_room,
                                                Roulette::by_albedo},
                                           Case{"open", &open_room, Roulette::by_albedo},
                                           Case{"lens", &seen_by_lens, Roulette::off}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(Techniques, HaveWeightsThatSumToOne) {
  for (const TechniqueSet& set : {all_techniques, find_estimator("pt").techniques})
    for (const Heuristic heuristic : {Heuristic::balance, Heuristic::power})
      for_each_path(2000, [&](const Space& space, const Path<Flatland>& x, int) {
        const auto brute = weights(space, x, set, heuristic == Heuristic::balance ? 1 : 2);
        double sum = 0;
        for (int s = 0; s <= x.size(); ++s) {
          if (!can_sample(space, x, s, set)) continue;
          const double w = sides_of(space, x, s, {set, heuristic}).mis_weight();
          ASSERT_NEAR(w, static_cast<double>(brute[static_cast<std::size_t>(s)]), 1e-12);
          sum += w;
        }
        ASSERT_NEAR(sum, 1, 1e-12) << path_class(x);
      });
}

TEST_P(Techniques, AreMeasuredAsTheyAreWeighted) {
  for_each_path(2000, [&](const Space& space, const Path<Flatland>& x, int) {
    Path<Flatland> y = x;
    weigh(space, y);
    ASSERT_EQ(y.contribution, contribution(x));
    Scaled sum;
    for (int s = 0; s <= x.size(); ++s) {
      const double w = y.weights()[static_cast<std::size_t>(s)];
      if (!can_sample(space, x, s, all_techniques)) {
        ASSERT_EQ(w, 0);
        continue;
      }
      ASSERT_NEAR(w, sides_of(space, x, s, {all_techniques, Heuristic::balance}).mis_weight(),
                  1e-12);
      sum += technique_density(x, s);
    }
    ASSERT_NEAR((y.intensity / sum).value(), 1, 1e-12);
  });
}

// Of walks that play roulette the same path has another intensity, which is known without them.
TEST_P(Techniques, KnowTheIntensityUnderRoulette) {
  int less = 0;
  for_each_path(2000, [&](const Space& space, const Path<Flatland>& x, int) {
    const auto measured = [&](Roulette roulette) {
      Path<Flatland> y = x;
      const Space other = space.with(roulette);
      for (int i = 0; i < x.size(); ++i) other.evaluate(y, i);
      weigh(other, y);
      return y;
    };
    const Path<Flatland> without = measured(Roulette::off), with = measured(Roulette::by_albedo);
    ASSERT_NEAR((without.intensity_under_roulette / with.intensity).value(), 1, 1e-12);
    less += (with.intensity / without.intensity).value() < 0.999;
  });
  EXPECT_GT(less, 100);
}

TEST_P(Techniques, DeliverTheQuotientOfContributionAndDensity) {
  for_each_path(2000, [&](const Space& space, const Path<Flatland>& x, int s) {
    const auto sides = sides_of(space, x, s, {all_techniques, Heuristic::balance});
    const double exact = (contribution(x) / technique_density(x, s)).value();
    ASSERT_NEAR(unweighted_contribution(x, s, sides) / exact, 1, 1e-12);
  });
}

// A path as it comes out of a sampler carries what its vertices alone determine.
TEST_P(Techniques, StoreWhatEvaluationFromScratchGives) {
  for_each_path(2000, [&](const Space& space, const Path<Flatland>& x, int s) {
    Path<Flatland> y = x;
    for (int i = 0; i + 1 < x.size(); ++i) ASSERT_NE(space.connect(y, i), Connection::facing_away);
    for (int i = 0; i < x.size(); ++i) space.evaluate(y, i);
    for (int i = 0; i < x.size(); ++i) {
      // Directions are made again from positions: short edges between curves lose digits.
      const double tolerance = 1e-6;
      const bool has_edge = i + 1 < x.size();
      ASSERT_NEAR(has_edge ? x[i].geometry / y[i].geometry : 1, 1, tolerance);
      ASSERT_NEAR(x[i].value / y[i].value, 1, tolerance) << path_class(x) << i << " s " << s;
      ASSERT_NEAR(x[i].from_light / y[i].from_light, 1, tolerance);
      ASSERT_NEAR(x[i].from_sensor / y[i].from_sensor, 1, tolerance);
    }
  });
}

TEST_P(Techniques, NeverConnectAtASpecularVertex) {
  int specular = 0;
  for_each_path(5000, [&](const Space& space, const Path<Flatland>& x, int s) {
    for (int i = 0; i < x.size(); ++i) specular += is_specular(x[i].event);
    if (s == 0 || s == x.size()) return;
    ASSERT_FALSE(is_specular(x[s - 1].event));
    ASSERT_FALSE(is_specular(x[s].event));
    ASSERT_TRUE(space.can_connect(x[s - 1]) && space.can_connect(x[s]));
  });
  EXPECT_EQ(specular > 0, std::string(GetParam().name) != "open");
}

TEST_P(Techniques, DoNotSampleWhatTheyAreNotAskedFor) {
  const auto scene = GetParam().make(6).build();
  const Space space(*scene, GetParam().roulette);
  for (const TechniqueSet set :
       {TechniqueSet{.most_light = 1}, TechniqueSet{.fewest_light = 2, .most_sensor = 2},
        TechniqueSet{2, 3, 1, 2}, TechniqueSet{.fewest_sensor = 4}}) {
    PathSampler<Space> sampler(space, set, Heuristic::power);
    Rng rng(2, Purpose::test, 0);
    for (int i = 0; i < 2000; ++i) {
      rng.start(static_cast<std::uint64_t>(i));
      sampler.sample(rng, [&](const Path<Flatland>& x, int s, double) {
        ASSERT_TRUE(set.holds(s, x.size() - s));
        ASSERT_LE(x.size(), 6);
      });
    }
  }
}

TEST_P(Techniques, SampleOnlyWhatTheirSetHoldsAndTheVerticesAllow) {
  constexpr TechniqueSet few{1, 2, 0, 3};
  for_each_path(2000, [&](const Space& space, const Path<Flatland>& x, int) {
    const int n = x.size();
    const auto fixed = [&](int i) { return is_specular(x[i].event); };
    for (int s = 0; s <= n; ++s) {
      const bool held = few.holds(s, n - s);
      ASSERT_TRUE(held || !can_sample(space, x, s, few));
      const bool forbidden = s > 0 && s < n && (fixed(s - 1) || fixed(s));
      ASSERT_FALSE(forbidden && can_sample(space, x, s, all_techniques)) << path_class(x) << s;
    }
  });
}

// A density that rounding made zero must not make a film infinite.
TEST_P(Techniques, DeliverNothingThatIsNotFinite) {
  for_each_path(200, [&](const Space& space, const Path<Flatland>& x, int s) {
    Path<Flatland> y = x;
    for (const double density : {0.0, 5e-324, -1.0}) {
      y[0].from_light = y[0].from_sensor = density;
      const double w =
          weighted_contribution(y, s, sides_of(space, y, s, {all_techniques, Heuristic::balance}));
      ASSERT_TRUE(std::isfinite(w) && w >= 0) << density;
    }
  });
}

// Light, mirror, sensor: only walks that reflect find it.
TEST(SpecularTechniques, GiveExactlyNothingByConnection) {
  SceneMaker maker(3);
  maker.segment({0, 0}, {2, 0}, {maker.mirror(0.9)}).segment({0.9, 1}, {0, 1}, {.radiance = 1});
  maker.segment({2, 1}, {1.1, 1}, {.bins = 2});
  const auto scene = maker.build();
  for (int s = 0; s <= 3; ++s) {
    const Estimator family{"", TechniqueSet{s, s, 3 - s, 3 - s}, Roulette::off, Heuristic::balance};
    const auto film = sample_film(*scene, family, 5000, 1);
    EXPECT_EQ(film.mean.value > 0, s == 0 || s == 3) << "s = " << s;
  }
}

// A vertex without a place is a camera, and cannot be hit.
TEST(CameraTechniques, DoWithoutHitsOnTheSensor) {
  const auto scene = seen_by_lens(5).build();
  const Space space(*scene, Roulette::off);
  EXPECT_FALSE(space.sensor_can_be_hit());
  for (int s = 2; s <= 5; ++s) {
    const Estimator family{"", TechniqueSet{s, s, 0, 0}, Roulette::off, Heuristic::balance};
    EXPECT_EQ(sample_film(*scene, family, 5000, 1).mean.value, 0);
  }
}

}  // namespace
}  // namespace wander::test
