// Proposals of the perturbations from a fixed path, against what they claim.
//
// Their moves, read off the path that they propose, are independent, log-uniform in distance and
// even in side: χ² over the joint cells.  And where q proposes with the density T that is claimed,
//   E_q[ [y in A] / T(x→y) ] = measure of A,
// an area of light times sensor, or of wall times sensor; a mirror between them leaves |det ∂c/∂A|
// of the δ in T (claimed_density.h).  False alarms: 1e-9 per decision.
#include <gtest/gtest.h>

#include "tests/support/claimed_density.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/perturbation_twins.h"
#include "tests/support/smooth_room.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// ---- the joint distribution of the moves

// Which cell a signed move falls in: its side, and its distance on a scale of equal ratios.
constexpr std::size_t scales = 3, sides = 2;
std::size_t cell_of_move(double move, LogUniform range) {
  const double part =
      std::log(range.largest / std::abs(move)) / std::log(range.largest / range.smallest);
  const auto scale = static_cast<std::size_t>(std::clamp(part, 0.0, 0.999999) * scales);
  return scale * sides + (move > 0 ? 1 : 0);
}

double moved_by(const Flat& space, const Path<W>& x, const Path<W>& y, int end) {
  return space.end_parameter(y, end)[0] - space.end_parameter(x, end)[0];
}
double turned_by(const Flat& space, const Path<W>& x, const Path<W>& y, int i, Toward toward) {
  const auto a = space.direction(x, i, toward), b = space.direction(y, i, toward);
  return std::atan2(cross(a, b), glm::dot(a, b));
}

// `end` moves, and directions turn at `turned`.  From x every proposal succeeds, or none of this
// would be uniform.
template <class Mutation>
Decision moves_are_independent(const Flat& space, const Mutation& mutation,
                               const PerturbationRange& range, const Path<W>& x, int end,
                               const std::vector<int>& turned, Toward toward) {
  std::size_t cells = scales * sides;
  for (std::size_t k = 0; k < turned.size(); ++k) cells *= scales * sides;
  std::vector<double> observed(cells);
  Path<W> y(space.max_vertices());
  Rng random(12, Purpose::test, 63);
  constexpr int proposals = 60'000;
  int failures = 0;
  for (int i = 0; i < proposals; ++i) {
    const Proposed proposed = mutation.propose(space, x, y, random);
    if (std::holds_alternative<Failure>(proposed)) {
      ++failures;
      continue;
    }
    std::size_t cell = cell_of_move(moved_by(space, x, y, end), range.position);
    for (const int v : turned)
      cell = cell * scales * sides + cell_of_move(turned_by(space, x, y, v, toward), range.angle);
    ++observed[cell];
  }
  EXPECT_EQ(failures, 0);
  const std::vector<double> expected(cells, proposals / static_cast<double>(cells));
  return chi_square_test(observed, expected, usual_false_alarm);
}

// A state of that class around which every small move succeeds.
template <class Mutation>
Path<W> calm_state(const Flat& space, const Mutation& mutation, const std::string& letters) {
  Starts<Flat> starts(space, 13);
  Path<W> y(space.max_vertices());
  Rng random(13, Purpose::test, 64);
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    if (!(starts.draw(i) > 0) || path_class(starts.path()) != letters) continue;
    int failures = 0;
    for (int k = 0; k < 300; ++k) {
      const Proposed proposed = mutation.propose(space, starts.path(), y, random);
      failures += std::holds_alternative<Failure>(proposed) ? 1 : 0;
    }
    if (failures == 0) return starts.path();
  }
  throw std::runtime_error("no state of class " + letters);
}

constexpr PerturbationRange small{.position{1e-4, 0.01}, .angle{1e-4, 0.01}};

class Moves : public ::testing::Test {
 protected:
  FlatScene scene_ = build(mirror_corridor());
  Flat space_{*scene_, Roulette::off};
};

TEST_F(Moves, OfTheLensPerturbationAreIndependentAndLogUniform) {
  for (const char* letters : {"LDE", "LSE", "LDSE"}) {
    const Path<W> x = calm_state(space_, Lens{small}, letters);
    const int end = x.size() - 1;
    EXPECT_TRUE(
        passes(moves_are_independent(space_, Lens{small}, small, x, end, {end}, Toward::light)))
        << letters;
    EXPECT_TRUE(rejects(moves_are_independent(space_, By<Lens, Lopsided>{{small}}, small, x, end,
                                              {end}, Toward::light)))
        << letters;
  }
}

TEST_F(Moves, OfTheCausticPerturbationAreIndependentAndLogUniform) {
  for (const char* letters : {"LDE", "LSE", "LSDE"}) {
    const Path<W> x = calm_state(space_, Caustic{small}, letters);
    EXPECT_TRUE(
        passes(moves_are_independent(space_, Caustic{small}, small, x, 0, {0}, Toward::sensor)))
        << letters;
    EXPECT_TRUE(rejects(moves_are_independent(space_, By<Caustic, Repeated>{{small}}, small, x, 0,
                                              {0}, Toward::sensor)))
        << letters;
  }
}

// Moves that share their numbers leave f invariant, for the way back shares them too, and reach but
// a line of the paths: only the joint distribution shows it.
TEST_F(Moves, OfTheMultiChainPerturbationAreIndependentAndLogUniform) {
  const Path<W> x = calm_state(space_, Multichain{small}, "LSDE");
  const std::vector<int> turned{3, 2};
  EXPECT_TRUE(
      passes(moves_are_independent(space_, Multichain{small}, small, x, 3, turned, Toward::light)));
  EXPECT_TRUE(rejects(moves_are_independent(space_, By<Multichain, Repeated>{{small}}, small, x, 3,
                                            turned, Toward::light)));
}

// ---- the measure of what is proposed

// Two positions, each along its wall.
struct Area {
  int first, second;  // vertices
  double first_low, first_high, second_low, second_high;
};

class Measure : public SmoothRoom {
 protected:
  static constexpr PerturbationRange wide_{.position{1e-3, 0.5}, .angle{1e-3, 1}};

  // E_q[ [y in A] |det ∂c/∂A| / T(x→y) ] against the measure of A.
  template <class Mutation>
  static Decision measure_of(const Flat& space, const Mutation& mutation, const Path<W>& x,
                             const Area& area) {
    const auto position = [&](const Path<W>& z, int i) { return space.end_parameter(z, i)[0]; };
    const auto length = [&](int i) {
      return visit_shape([](const auto& s) { return s.measure(); },
                         space.scene().shape(x[i].place.shape));
    };
    const DensityOfMoves<W> density(space);
    Path<W> y(space.max_vertices());
    Rng random(14, Purpose::test, 65);
    Moments estimate;
    for (int i = 0; i < 400'000; ++i) {
      const Proposed proposed = mutation.propose(space, x, y, random);
      const Proposal* p = std::get_if<Proposal>(&proposed);
      const bool inside = p && y[area.first].place.shape == x[area.first].place.shape &&
                          y[area.second].place.shape == x[area.second].place.shape &&
                          position(y, area.first) >= area.first_low &&
                          position(y, area.first) < area.first_high &&
                          position(y, area.second) >= area.second_low &&
                          position(y, area.second) < area.second_high;
      estimate.add(inside ? density.constraint(x, y) / p->forward.value() : 0);
    }
    const double measure = length(area.first) * (area.first_high - area.first_low) *
                           length(area.second) * (area.second_high - area.second_low);
    return z_test(estimate, measure, usual_false_alarm);
  }

  Path<W> by_wall() const { return path({{light_wall, 0.4}, {7, 0.6}, {sensor_wall, 0.3}}); }
};

TEST_F(Measure, OfWallTimesSensorIsThatOfTheLensPerturbation) {
  const Area area{1, 2, 0.2, 0.4, 0.5, 0.7};
  EXPECT_TRUE(passes(measure_of(space_, Lens{wide_}, by_wall(), area)));
  EXPECT_TRUE(rejects(measure_of(space_, In<Lens, WithoutCosine>{{wide_}}, by_wall(), area)));
  EXPECT_TRUE(rejects(measure_of(space_, In<Lens, WithoutEndDensity>{{wide_}}, by_wall(), area)));
}

TEST_F(Measure, OfLightTimesWallIsThatOfTheCausticPerturbation) {
  const Area area{0, 1, 0.5, 0.7, 0.2, 0.4};
  EXPECT_TRUE(passes(measure_of(space_, Caustic{wide_}, by_wall(), area)));
  EXPECT_TRUE(rejects(measure_of(space_, In<Caustic, WithoutCosine>{{wide_}}, by_wall(), area)));
  EXPECT_TRUE(
      rejects(measure_of(space_, In<Caustic, WithoutEndDensity>{{wide_}}, by_wall(), area)));
}

// The wall x = 0 is a mirror: what light and sensor see of each other is the image behind it.
class MeasureByMirror : public Measure {
 protected:
  static description::Scene mirrored() {
    description::Scene scene = smooth_room();
    scene.materials.push_back({"mirror", description::Mirror{{{0.9, 0.9, 0.9}, false}}});
    scene.shapes[7].material = 1;
    return scene;
  }
  Path<W> by_mirror() const {
    const auto at = [&](ShapeId wall, double u) {
      return std::get<Segment<W>>(mirror_scene_->shape(wall)).sample({u}).position;
    };
    const auto light = at(light_wall, 0.5), sensor = at(sensor_wall, 0.3);
    const double height = (light.y * sensor.x + sensor.y * light.x) / (light.x + sensor.x);
    Path<W> x(4);
    x.resize(3);
    put(x, 0, light_wall, 0.5);
    put(x, 1, 7, (1.1 - height) / 1.1);
    put(x, 2, sensor_wall, 0.3);
    x[1].event = Event::reflection;
    for (int i = 0; i < 2; ++i) EXPECT_EQ(mirror_space_.connect(x, i), Connection::open);
    EXPECT_EQ(evaluate(mirror_space_, x, 0, 2), Reason::none);
    return x;
  }
  FlatScene mirror_scene_ = build(mirrored());
  Flat mirror_space_{*mirror_scene_, Roulette::off};
};

TEST_F(MeasureByMirror, OfLightTimesSensorIsThatOfLensAndCausticPerturbations) {
  const Path<W> x = by_mirror();
  const Area area{0, 2, 0.1, 0.3, 0.4, 0.6};
  EXPECT_TRUE(passes(measure_of(mirror_space_, Lens{wide_}, x, area)));
  EXPECT_TRUE(passes(measure_of(mirror_space_, Caustic{wide_}, x, area)));
  EXPECT_TRUE(rejects(measure_of(mirror_space_, In<Lens, WithoutCosine>{{wide_}}, x, area)));
  EXPECT_TRUE(rejects(measure_of(mirror_space_, In<Caustic, WithoutEndDensity>{{wide_}}, x, area)));
}

}  // namespace
}  // namespace wander::test
