// Exact visibility: the reference scenes, random scenes against dense ray casting, and wrong twins.
#include "tests/support/crossed_strings.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "core/exact/visibility.h"
#include "tests/support/generator.h"
#include "tests/support/reference_values.h"

namespace wander::test {
namespace {

PlaneSegment bin_of(const PlaneSegment& s, std::size_t bin, std::size_t bins) {
  const auto n = static_cast<double>(bins);
  return {s.at(static_cast<double>(bin) / n), s.at(static_cast<double>(bin + 1) / n)};
}

// The irradiance by casting rays at equal steps of sin θ: an independent, slow and coarse answer.
double cast_irradiance(const Receiver& x, const std::vector<LambertSegment>& scene, int rays) {
  const PlanePoint n = x.normal, t{n.y, -n.x};
  double sum = 0;
  for (int i = 0; i < rays; ++i) {
    const double sine = -1 + (2 * i + 1.0) / rays;
    const PlanePoint ray = sine * t + std::sqrt(1 - sine * sine) * n;
    double nearest = 1e300, seen = 0;
    for (const LambertSegment& s : scene) {
      const PlanePoint e = s.segment.to - s.segment.from, o = s.segment.from - x.position;
      const double distance = cross(o, e) / cross(ray, e), position = cross(o, ray) / cross(ray, e);
      if (!(distance > 1e-9 && distance < nearest && position >= 0 && position <= 1)) continue;
      nearest = distance;
      seen = dot(ray, normal(s.segment)) < 0 ? s.radiance : 0;
    }
    sum += seen * 2 / rays;
  }
  return sum;
}

TEST(CrossedStrings, ParallelEmitterIsReproduced) {
  namespace a = reference::parallel_emitter;
  const std::vector<LambertSegment> scene{{a::emitter, a::radiance}};
  EXPECT_NEAR(point_irradiance({a::point, {0, 1}}, scene), a::point_irradiance, a::tolerance);
  for (std::size_t i = 0; i < a::film.size(); ++i) {
    const PlaneSegment bin = bin_of(a::sensor, i, a::film.size());
    EXPECT_NEAR(mean_irradiance(bin, scene), a::film[i], a::tolerance);
    EXPECT_NEAR(a::radiance * crossed_strings(bin, a::emitter) / length(bin), a::film[i],
                a::tolerance);
  }
}

TEST(CrossedStrings, TheBlockerIsReproducedAndItsAbsenceIsNot) {
  using namespace reference::blocker;
  const std::vector<LambertSegment> scene{{emitter, radiance}, {obstacle, 0}};
  const std::vector<LambertSegment> without{{emitter, radiance}};
  for (std::size_t b = 0; b < film.size(); ++b) {
    const PlaneSegment bin = bin_of(sensor, b, film.size());
    EXPECT_NEAR(mean_irradiance(bin, scene), film[b], tolerance);
    EXPECT_GT(mean_irradiance(bin, without), film[b] + 1e-3);
  }
}

TEST(CrossedStrings, TheSharedCornerIsReproduced) {
  using namespace reference::corner;
  const std::vector<LambertSegment> scene{{emitter, radiance}};
  for (const Bin& bin : floor_bins) {
    const PlaneSegment floor{{bin.from, 0}, {bin.to, 0}};
    EXPECT_NEAR(mean_irradiance(floor, scene), bin.mean_irradiance, tolerance);
    EXPECT_NEAR(crossed_strings(floor, emitter) / length(floor), bin.mean_irradiance, 1e-9);
  }
}

TEST(CrossedStrings, ClosedFormsOfPairsHold) {
  const PlaneSegment a{{0, 0}, {1, 0}}, above{{1, 0.5}, {0, 0.5}}, beside{{1, 0}, {1, 2}};
  EXPECT_NEAR(crossed_strings(a, above) / 2, 0.618033988749895, 1e-15);
  EXPECT_NEAR(crossed_strings(a, beside) / 2, (1 + 2 - std::sqrt(5.0)) / 2, 1e-15);
}

TEST(CrossedStrings, AnEmitterIsDarkFromBehind) {
  const PlaneSegment down{{1, 1}, {-1, 1}}, up{{-1, 1}, {1, 1}};
  const Receiver floor{{0, 0}, {0, 1}}, ceiling{{0, 2}, {0, -1}};
  EXPECT_GT(point_irradiance(floor, std::vector<LambertSegment>{{down, 1}}), 1);
  EXPECT_EQ(point_irradiance(floor, std::vector<LambertSegment>{{up, 1}}), 0);
  EXPECT_EQ(point_irradiance(ceiling, std::vector<LambertSegment>{{down, 1}}), 0);
  EXPECT_GT(point_irradiance(ceiling, std::vector<LambertSegment>{{up, 1}}), 1);
}

TEST(CrossedStrings, InsideAClosedPolygonNoDirectionEscapes) {
  const std::vector<PlanePoint> star{{0, 0}, {2, 0.1}, {2, 2}, {1.1, 0.7}, {0.2, 2.2}};
  std::vector<LambertSegment> scene;
  for (std::size_t i = 0; i < star.size(); ++i)
    scene.push_back({{star[i], star[(i + 1) % star.size()]}, 1});
  Generator g(1);
  for (int i = 0; i < 200; ++i) {
    const PlaneSegment floor = scene[0].segment;
    const Receiver x{floor.at(g.uniform()), normal(floor)};
    EXPECT_NEAR(point_irradiance(x, scene), 2, 1e-12);
  }
}

TEST(CrossedStrings, RandomScenesOfCrossingSegmentsAgreeWithRayCasting) {
  Generator g(2);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<LambertSegment> scene;
    for (int i = 0; i < 10; ++i) {
      const PlanePoint p{2 * g.uniform() - 1, 0.1 + g.uniform()};
      const PlanePoint q = p + PlanePoint{g.uniform() - 0.5, g.uniform() - 0.5};
      scene.push_back({{p, q}, i % 3 == 0 ? 0 : g.uniform()});
    }
    const double angle = 2 * g.uniform() - 1;
    const Receiver x{{g.uniform() - 0.5, 0}, {std::sin(angle), std::cos(angle)}};
    EXPECT_NEAR(point_irradiance(x, scene), cast_irradiance(x, scene, 20'000), 2e-3) << trial;
  }
}

TEST(CrossedStrings, VisibleIntervalsNameSideAndPosition) {
  const std::vector<PlaneSegment> scene{{{1, 1}, {-1, 1}}, {{-0.5, 0.5}, {0, 0.5}}};
  const auto seen = Visibility(scene).from({{0, 0}, {0, 1}});
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].segment, 1u);  // the near one hides the left half
  EXPECT_EQ(seen[0].side, Side::back);
  EXPECT_EQ(seen[1].segment, 0u);
  EXPECT_EQ(seen[1].side, Side::front);
  EXPECT_NEAR(seen[1].at_from, 0.5, 1e-15);
  EXPECT_NEAR(seen[1].at_to, 0, 1e-15);
  EXPECT_NEAR(seen[1].theta_to, std::numbers::pi / 4, 1e-15);
}

TEST(CrossedStrings, OverlappingAndEmptySegmentsAreRefused) {
  const std::vector<PlaneSegment> overlapping{{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}};
  const std::vector<PlaneSegment> empty{{{1, 1}, {1, 1}}};
  const std::vector<PlaneSegment> in_line{{{0, 0}, {1, 0}}, {{1, 0}, {3, 0}}};
  EXPECT_THROW(Visibility{overlapping}, std::invalid_argument);
  EXPECT_THROW(Visibility{empty}, std::invalid_argument);
  EXPECT_EQ(Visibility(in_line).pieces().size(), 2u);
}

}  // namespace
}  // namespace wander::test
