// Naive path tracing and naive light tracing sample the same paths from opposite ends.  With one
// light and one sensor, both black, over diffuse and mirror surfaces and without roulette, a path
// of weight X from the sensor has the weight X |light| / |sensor| from the light, so that
//   E X_pt² : E X_lt² = |sensor| : |light|.
// False-alarm rate 1e-9.
#include <gtest/gtest.h>

#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

constexpr double sensor_length = 1.2;

SceneMaker mixed_room(double light_length, std::optional<double> reflectance) {
  SceneMaker maker(6);
  const std::size_t plaster = maker.diffuse(0.75);
  Role light{.radiance = 1}, sensor{.bins = 5};
  if (reflectance) light.material = sensor.material = maker.diffuse(*reflectance);
  maker.segment({0.2, 0}, {0.2 + sensor_length, 0}, sensor);
  maker.segment({1.1, 1}, {1.1 - light_length, 1}, light);
  maker.segment({2, 0.1}, {2, 0.9}, {maker.mirror(0.9)}).segment({0, 0.9}, {0, 0.1}, {plaster});
  maker.segment({0.8, 0.5}, {1.2, 0.6}, {plaster}).segment({1.9, 1.05}, {1.2, 1.05}, {plaster});
  maker.arc({0.4, 0.5}, 0.1, 0, 200, {plaster});
  return maker;
}

Moments second_moment(const Scene<Flatland>& scene, const Estimator& estimator,
                      std::uint64_t seed) {
  PathSampler<Transport<Flatland>> sampler(Transport<Flatland>(scene, estimator.roulette),
                                           estimator.techniques, estimator.heuristic);
  Rng rng(seed, Purpose::test, 0);
  Moments moments;
  for (int i = 0; i < 500'000; ++i) {
    rng.start(static_cast<std::uint64_t>(i));
    double total = 0;
    sampler.sample(rng, [&](const Path<Flatland>&, int, double weighted) { total += weighted; });
    moments.add(total * total);
  }
  return moments;
}

// Each second moment over the length of its own end: the same number.
Decision compare_moments(const SceneMaker& maker, double light_length) {
  const auto scene = maker.build();
  const Moments pt = second_moment(*scene, find_estimator("pt-naive"), 1);
  const Moments lt = second_moment(*scene, find_estimator("lt-naive"), 2);
  // The error of both stands with the first, as if the second were exact.
  return z_test(pt.mean() / sensor_length,
                std::hypot(pt.standard_error() / sensor_length, lt.standard_error() / light_length),
                lt.mean() / light_length, usual_false_alarm);
}

TEST(SecondMoments, StandAsSensorToLight) {
  for (const double light_length : {sensor_length, 0.5, 0.1})
    EXPECT_TRUE(passes(compare_moments(mixed_room(light_length, {}), light_length)))
        << "light of length " << light_length;
}

// Controls: the lengths matter, and so does that both ends are black.
TEST(SecondMoments, AreNotEqualForUnequalLengths) {
  EXPECT_TRUE(rejects(compare_moments(mixed_room(0.5, {}), sensor_length)));
}
TEST(SecondMoments, StandOtherwiseWhenLightAndSensorScatter) {
  EXPECT_TRUE(rejects(compare_moments(mixed_room(0.2, 0.95), 0.2)));
}

}  // namespace
}  // namespace wander::test
