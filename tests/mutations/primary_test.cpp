// The primary steps: Kelemen's kernel in one coordinate, and the maps between a path and the random
// numbers that make it, there and back.
#include <gtest/gtest.h>

#include <numeric>

#include "core/path_sampler.h"
#include "mutations/kelemen.h"
#include "mutations/primary_small.h"
#include "tests/support/chi_square.h"
#include "tests/support/expect.h"
#include "tests/support/generator.h"
#include "tests/support/test_scenes.h"
#include "tests/support/wrong_twins.h"

namespace wander::test::primary_test {
namespace {

// ---- one coordinate

// A kernel with a large range, so that a step often meets the ends.
constexpr Kelemen far_reaching{1.0 / 64, 0.4};

template <class Kernel>
Decision stays_uniform(const Kernel& kernel, std::uint64_t seed) {
  Generator random(seed);
  std::vector<double> values;
  for (int i = 0; i < 200'000; ++i) {
    double u = random.uniform();
    for (int step = 0; step < 5; ++step) u = kernel.move(u, random).u;
    values.push_back(u);
  }
  return uniformity_test(values, usual_false_alarm, 128);
}

TEST(Kelemen, KeepsUniformNumbersUniform) {
  EXPECT_TRUE(passes(stays_uniform(Kelemen{}, 1)));
  EXPECT_TRUE(passes(stays_uniform(far_reaching, 2)));
}

TEST(Kelemen, ATwinThatClampsInsteadOfWrappingIsCaught) {
  EXPECT_TRUE(rejects(stays_uniform(ClampedKelemen{}, 3)));
}

// 1 / (2 |v - u| ln(s2/s1)) around the circle.
double density_of_move(const Kelemen& kernel, double u, double v) {
  const double across = std::abs(v - u), distance = std::min(across, 1 - across);
  if (distance < kernel.smallest || distance > kernel.largest) return 0;
  return 1 / (2 * distance * std::log(kernel.largest / kernel.smallest));
}

TEST(Kelemen, ItsDensityIsThatOfItsMovesAndIntegratesToOne) {
  for (const double u : {0.0, 0.001, 0.3, 0.995}) {
    SCOPED_TRACE(u);
    Generator random(4);
    const auto sample = [&]() -> std::optional<CubePoint<1>> {
      return CubePoint<1>{far_reaching.move(u, random).u};
    };
    const auto density = [&](const CubePoint<1>& v) {
      return density_of_move(far_reaching, u, v[0]);
    };
    EXPECT_TRUE(passes(sampler_matches_density<1>(sample, density)));
    EXPECT_NEAR(integral<1>(density, Box<1>{{0}, {1}}, {.absolute = 1e-9, .depth = 30}), 1, 1e-6);
  }
}

TEST(Kelemen, ClaimsTheDensityOfTheMoveThatItMade) {
  Generator random(5);
  for (int i = 0; i < 100'000; ++i) {
    const double u = random.uniform();
    const Kelemen::Move move = Kelemen{}.move(u, random);
    const double across = std::abs(move.u - u), distance = std::min(across, 1 - across);
    ASSERT_NEAR(move.density * 2 * distance * std::log(16.0), 1, 1e-9);
  }
}

// Plays given numbers.
struct Script {
  std::vector<double> numbers;
  std::size_t next = 0;
  double uniform() { return numbers[next++ % numbers.size()]; }
};

TEST(Kelemen, NeverReachesOne) {
  const double below_one = std::nextafter(1.0, 0.0);
  const Kelemen tiny{1e-30, 1e-17};
  for (const Kelemen& kernel : {Kelemen{}, far_reaching, tiny}) {
    for (const double u : {0.0, 1e-20, 0.5, 1 - 1.0 / 64, below_one}) {
      for (const double number : {0.0, 0.25, std::nextafter(0.5, 0.0), 0.5, 0.75, below_one}) {
        Script script{{number}};
        const double moved = kernel.move(u, script).u;
        EXPECT_GE(moved, 0);
        EXPECT_LT(moved, 1);
      }
    }
  }
}

// ---- paths to numbers and back

using W = Flatland;
using Flat = Transport<W>;

constexpr double tolerance = 1e-9;  // in rooms of about the unit square

::testing::AssertionResult same_vertex(const Vertex<W>& a, const Vertex<W>& b) {
  const double distance = glm::length(a.place.position - b.place.position);
  if (a.place.shape == b.place.shape && distance < tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "on shapes " << a.place.shape << " and " << b.place.shape
                                       << ", " << distance << " apart";
}

// Makes each vertex of a subpath of x anew, from the true ones before it.
void expect_round_trip(const Flat& space, const Path<W>& x, Toward toward, int count, Rng& random) {
  if (count == 0) return;
  const bool from_light = toward == Toward::sensor;
  const int end = from_light ? 0 : x.size() - 1, step = from_light ? 1 : -1;
  Path<W> y(space.max_vertices());
  y.resize(x.size());
  const PointNumbers<W> point = space.invert_begin(x, end, random);
  if (from_light)
    space.begin_light(y, end, point);
  else
    space.begin_sensor(y, end, point);
  ASSERT_TRUE(same_vertex(x[end], y[end]));
  ASSERT_EQ(x[end].event, y[end].event);
  for (int k = 0, i = end; k + 1 < count; ++k, i += step) {
    const ScatterNumbers<W> numbers = space.invert_extend(x, i, toward, random);
    ASSERT_TRUE(numbers.direction[0] >= 0 && numbers.direction[0] < 1) << numbers.direction[0];
    ASSERT_TRUE(numbers.lobe >= 0 && numbers.lobe < 1) << numbers.lobe;
    y = x;
    ASSERT_TRUE(space.extend(y, i, toward, numbers)) << path_class(x) << " at " << i;
    ASSERT_TRUE(same_vertex(x[i + step], y[i + step])) << path_class(x) << " at " << i;
    ASSERT_EQ(x[i].event, y[i].event) << path_class(x) << " at " << i;
  }
}

class InverseMap : public ::testing::TestWithParam<int> {};

TEST_P(InverseMap, MakesTheSamePathWithEveryTechniqueThatCan) {
  const NamedScene named = lit_scenes()[static_cast<std::size_t>(GetParam())];
  const FlatScene scene = build(named.scene);
  const Flat space(*scene, Roulette::off);
  PathSampler<Flat> sampler(space, all_techniques, Heuristic::balance);
  Rng random(1, Purpose::test, 10), auxiliary(1, Purpose::test, 11);
  int round_trips = 0;
  for (std::uint64_t i = 0; i < 2000 && !HasFatalFailure(); ++i) {
    random.start(i);
    auxiliary.start(i);
    sampler.sample(random, [&](const Path<W>& x, int, double) {
      for (int s = 0; s <= x.size() && !HasFatalFailure(); ++s) {
        if (!can_sample(space, x, s, all_techniques)) continue;
        expect_round_trip(space, x, Toward::sensor, s, auxiliary);
        expect_round_trip(space, x, Toward::light, x.size() - s, auxiliary);
        ++round_trips;
      }
    });
  }
  EXPECT_GT(round_trips, 1000);
}

// T(x→y) = w_s(x) K p_s(y) with the technique s that the first number chooses; K is the same both
// ways, so T(x→y) / T(y→x) is known.
TEST_P(InverseMap, OfASmallStepHasTheDensitiesOfOneTechnique) {
  const FlatScene scene = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
  const Flat space(*scene, Roulette::off);
  PathSampler<Flat> sampler(space, all_techniques, Heuristic::balance);
  Rng random(1, Purpose::test, 12), numbers(1, Purpose::test, 13);
  Path<W> x(space.max_vertices()), y(space.max_vertices());
  int proposals = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    random.start(i);
    numbers.start(i);
    sampler.sample(random, [&](const Path<W>& found, int, double) {
      x = found;
      weigh(space, x);
      Rng again = numbers;
      const auto s = static_cast<std::size_t>(again.choose(x.weights()));
      const Proposed proposed = PrimarySmall{}.propose(space, x, y, numbers);
      const Proposal* p = std::get_if<Proposal>(&proposed);
      if (!p || p->reverse.is_zero()) return;
      ++proposals;
      const int technique = static_cast<int>(s);
      const Scaled there = Scaled(x.weights()[s]) * technique_density(y, technique);
      const Scaled back = Scaled(y.weights()[s]) * technique_density(x, technique);
      ASSERT_NEAR((p->forward / p->reverse / (there / back)).value(), 1, 1e-12);
    });
  }
  EXPECT_GT(proposals, 500);
}

// Which lamp, or which lobe: a path fixes no number that chooses.
bool has_choices(const Flat& space, const Path<W>& x, int s) {
  if (s > 0 && space.chooses_light(x[0])) return true;
  for (int i = 0; i < x.size(); ++i)
    if (is_specular(x[i].event) || space.chooses_lobe(x[i])) return true;
  return false;
}

// The random numbers of technique s that a path fixes, first from the light and then from the sensor.
std::vector<double> numbers_of(const Flat& space, const Path<W>& x, int s, Rng& random) {
  std::vector<double> numbers;
  const auto add = [&](Toward toward, int count) {
    if (count == 0) return;
    const bool from_light = toward == Toward::sensor;
    const int end = from_light ? 0 : x.size() - 1;
    const PointNumbers<W> point = space.invert_begin(x, end, random);
    if (!space.is_pinhole(x[end])) numbers.push_back(point.position[0]);
    for (int k = 0, i = end; k + 1 < count; ++k, i += from_light ? 1 : -1)
      numbers.push_back(space.invert_extend(x, i, toward, random).direction[0]);
  };
  add(Toward::sensor, s);
  add(Toward::light, x.size() - s);
  return numbers;
}

// T(x→y) whole: K of all numbers that moved.  What cancels in the acceptance is in the logs all the same.
TEST_P(InverseMap, OfASmallStepHasTheDensityOfEachMove) {
  const FlatScene scene = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
  const Flat space(*scene, Roulette::off);
  PathSampler<Flat> sampler(space, all_techniques, Heuristic::balance);
  Rng random(1, Purpose::test, 12), numbers(1, Purpose::test, 14);
  Path<W> x(space.max_vertices()), y(space.max_vertices());
  int proposals = 0;
  const auto look_at = [&] {
    weigh(space, x);
    Rng again = numbers;
    const int s = again.choose(x.weights());
    const Proposed proposed = PrimarySmall{}.propose(space, x, y, numbers);
    const Proposal* p = std::get_if<Proposal>(&proposed);
    if (!p || has_choices(space, x, s) || has_choices(space, y, s)) return;
    ++proposals;
    const std::vector<double> u = numbers_of(space, x, s, again),
                              v = numbers_of(space, y, s, again);
    ASSERT_EQ(u.size(), v.size());
    double expected = x.weights()[static_cast<std::size_t>(s)] * technique_density(y, s).value();
    for (std::size_t k = 0; k < u.size(); ++k) {
      const double across = std::abs(v[k] - u[k]), distance = std::min(across, 1 - across);
      expected /=
          2 * distance * std::log(PrimarySmall{}.kernel.largest / PrimarySmall{}.kernel.smallest);
    }
    ASSERT_NEAR(p->forward.value() / expected, 1, 1e-6) << path_class(x) << ", technique " << s;
  };
  for (std::uint64_t i = 0; i < 2000 && !HasFatalFailure(); ++i) {
    random.start(i);
    numbers.start(i);
    sampler.sample(random, [&](const Path<W>& found, int, double) {
      x = found;
      if (!HasFatalFailure()) look_at();
    });
  }
  EXPECT_GT(proposals, 500);
}

INSTANTIATE_TEST_SUITE_P(Rooms, InverseMap,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())),
                         [](const auto& test) {
                           std::string name =
                               lit_scenes()[static_cast<std::size_t>(test.param)].name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

// ---- lobes

// Where a step comes from a wall to glass, light is reflected there with Fresnel's probability: the
// number that chooses has no past.  The path that is proposed may fail farther on; that is decided later.
TEST(SmallSteps, ThatComeToGlassChooseTheirLobeAnew) {
  const FlatScene scene = build(mirror_and_glass());
  const Transport<Flatland> space(*scene, Roulette::off);
  PathSampler<Transport<Flatland>> sampler(space, all_techniques, Heuristic::balance);
  const PrimarySmall small{Kelemen{1.0 / 64, 0.4}};
  Path<Flatland> y(space.max_vertices());
  double reflected = 0, expected = 0, variance = 0;
  const auto look_at = [&](const Path<Flatland>& x, Rng& random) {
    y.resize(x.size());
    for (int i = 0; i < y.size(); ++i) y[i].place.shape = no_shape;  // nobody has been here
    small.propose(space, x, y, random);
    for (int i = 1; i + 1 < x.size(); ++i) {
      const Vertex<Flatland>& v = y[i];
      if (x[i].event != Event::scattering || space.chooses_lobe(x[i])) continue;
      if (v.event != Event::reflection && v.event != Event::transmission) continue;
      if (v.place.shape == no_shape || y[i - 1].place.shape == no_shape ||
          y[i + 1].place.shape == no_shape || !space.chooses_lobe(v))
        continue;
      const double cosine = glm::dot(v.place.normal, v.place.to_sensor);
      const bool outside = cosine > 0;
      const double f = fresnel(std::abs(cosine), outside ? 1.0 : 1.5, outside ? 1.5 : 1.0);
      reflected += v.event == Event::reflection ? 1 : 0;
      expected += f;
      variance += f * (1 - f);
    }
  };
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    Rng random(1, Purpose::test, 31);
    random.start(i);
    sampler.sample(random, [&](const Path<Flatland>& x, int, double) {
      Rng step(1, Purpose::test, 32);
      step.start(i);
      look_at(x, step);
    });
  }
  EXPECT_GT(variance, 100);
  EXPECT_TRUE(passes(z_test(reflected, std::sqrt(variance), expected, usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test::primary_test
