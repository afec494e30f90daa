// In space: the densities that the bidirectional mutation and the large step claim, against the
// histograms of what they propose (density_test.cpp and density_bidirectional_test.cpp say how).
// False alarms: 1e-9 per χ².
#include <gtest/gtest.h>

#include "mlt/join.h"
#include "mutations/bidirectional.h"
#include "mutations/primary_large.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"
#include "tests/support/wrong_twins.h"

namespace wander::test::space_density_test {
namespace {

using W = Spaceland;
using Point = W::Point;
using Sheet = Parallelogram<W>;
using Square = std::array<double, 2>;

constexpr ShapeId light_wall = 1, sensor_wall = 0;
constexpr std::size_t wall_count = 6;
constexpr int proposals = 120'000;

// A leaning box: one of two opposite walls is the sensor, the other the light.
SceneParts<W> leaning_box() {
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.7}};
  const Point o(0, 0, 0), x(1, 0.1, 0), y(0, 1.2, 0.1), z(0.2, 0, 1);
  for (const Sheet& sheet : {Sheet(o, x, y), Sheet(z, y, x), Sheet(o, y, z), Sheet(x, z, y),
                             Sheet(o, z, x), Sheet(y, x, z)})
    parts.parts.push_back({sheet, 0, 0, false});
  parts.parts[sensor_wall].is_sensor = true;
  parts.parts[light_wall].radiance = 1;
  parts.resolution = {1, 1};
  parts.max_vertices = 4;
  return parts;
}

// Paths are chosen by hand: a vertex is a wall and a place on it.
class LeaningBox : public ::testing::Test {
 protected:
  struct Place {
    ShapeId wall;
    Square at;
  };

  const Sheet& sheet(std::size_t wall) const {
    return std::get<Sheet>(scene_.shape(static_cast<ShapeId>(wall)));
  }
  void put(Path<W>& x, int i, ShapeId wall, Square at) const {
    const auto point = sheet(static_cast<std::size_t>(wall)).sample({at[0], at[1]});
    x[i].place = {.position = point.position, .normal = point.normal, .shape = wall};
    x[i].event = i == 0              ? Event::emission
                 : i == x.size() - 1 ? Event::detection
                                     : Event::scattering;
  }
  // Edges and measures.  False: no light gets through.
  bool complete(Path<W>& x) const {
    for (int i = 0; i + 1 < x.size(); ++i)
      if (space_.connect(x, i) != Connection::open) return false;
    return evaluate(space_, x, 0, x.size() - 1) == Reason::none;
  }
  Path<W> path(std::initializer_list<Place> places) const {
    Path<W> x(space_.max_vertices());
    x.resize(static_cast<int>(places.size()));
    int i = 0;
    for (const auto& [wall, at] : places) put(x, i++, wall, at);
    EXPECT_TRUE(complete(x));
    weigh(space_, x);
    return x;
  }
  Path<W> two() const { return path({{light_wall, {0.4, 0.5}}, {sensor_wall, {0.55, 0.4}}}); }
  Path<W> three() const {
    return path({{light_wall, {0.4, 0.5}}, {4, {0.6, 0.5}}, {sensor_wall, {0.55, 0.4}}});
  }
  // Of `per_axis` × `per_axis` cells.
  std::size_t cell(const Vertex<W>& v, std::size_t per_axis) const {
    const auto u = sheet(static_cast<std::size_t>(v.place.shape)).parameter(v.place.position);
    const auto n = static_cast<double>(per_axis);
    return static_cast<std::size_t>(u[1] * n) * per_axis + static_cast<std::size_t>(u[0] * n);
  }
  static Box<2> box(std::size_t cell, std::size_t per_axis) {
    const auto n = static_cast<double>(per_axis);
    const auto column = static_cast<double>(cell % per_axis),
               row = static_cast<double>(cell / per_axis);
    return {{column / n, row / n}, {(column + 1) / n, (row + 1) / n}};
  }

  const Scene<W> scene_{leaning_box()};
  const Transport<W> space_{scene_, Roulette::off};
};

class NewVertexInSpace : public LeaningBox {
 protected:
  static constexpr std::size_t per_axis = 4, per_wall = per_axis * per_axis;
  using B = Bidirectional;

  // Proposals that keep these vertices of x and add one, by the cell of that one.
  std::vector<double> proposed(const Path<W>& x, B::Kept kept) const {
    std::vector<double> counts(per_wall * wall_count + 1);
    Path<W> y(space_.max_vertices());
    Rng random(4, Purpose::test, 23);
    for (int i = 0; i < proposals; ++i) {
      const Proposed made = B{}.propose(space_, x, y, random);
      const auto same = kept_vertices(x, y);
      const bool counts_here = std::holds_alternative<Proposal>(made) && same.light == kept.light &&
                               same.sensor == kept.sensor &&
                               y.size() == kept.light + kept.sensor + 1;
      const auto& fresh = y[kept.light];
      ++counts[counts_here
                   ? static_cast<std::size_t>(fresh.place.shape) * per_wall + cell(fresh, per_axis)
                   : counts.size() - 1];
    }
    return counts;
  }
  // `flaw(z)` spoils the claim by a factor.
  template <class Flaw>
  Decision against(const Path<W>& x, B::Kept kept, const Flaw& flaw) const {
    const int n = kept.light + kept.sensor + 1, d = x.size() - kept.light - kept.sensor;
    Path<W> z(space_.max_vertices());
    z.resize(n);
    z.copy(x, 0, kept.light, 0);
    z.copy(x, x.size() - kept.sensor, kept.sensor, n - kept.sensor);
    const auto density = [&](std::size_t wall, Square at) {
      const auto id = static_cast<ShapeId>(wall);
      if (kept.light == 0 && id != light_wall) return 0.0;
      if (kept.sensor == 0 && id != sensor_wall) return 0.0;
      put(z, kept.light, id, at);
      if (!complete(z)) return 0.0;
      const double choice = B::delete_probability(x.size(), d, kept) *
                            B::add_probability(kept, d, 1, space_.max_vertices());
      return flaw(z) * choice * B::added_density(space_, z, kept, 1).value();
    };
    const std::vector<double> observed = proposed(x, kept);
    std::vector<double> expected(observed.size());
    double total = 0;
    for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
      const std::size_t wall = i / per_wall;
      const auto at = [&](const Square& u) { return sheet(wall).measure() * density(wall, u); };
      total += expected[i] =
          proposals * gauss_integral<2>(at, box(i % per_wall, per_axis), gauss_rule(7));
    }
    expected.back() = proposals - total;
    return chi_square_test(observed, expected, usual_false_alarm);
  }
  Decision claimed(const Path<W>& x, B::Kept kept) const {
    return against(x, kept, [](const Path<W>&) { return 1.0; });
  }
};

TEST_F(NewVertexInSpace, HasTheDensityThatTheBidirectionalMutationClaims) {
  EXPECT_TRUE(passes(claimed(three(), {1, 1})));  // in place of another
  EXPECT_TRUE(passes(claimed(two(), {1, 1})));    // inserted
  EXPECT_TRUE(passes(claimed(two(), {0, 1})));    // on the light
  EXPECT_TRUE(passes(claimed(three(), {2, 0})));  // on the sensor
}
TEST_F(NewVertexInSpace, WithTheGeometryTermOfThePlaneIsCaught) {
  const auto of_the_plane = [](const Path<W>& z) {
    return glm::length(z[1].place.position - z[0].place.position);
  };
  EXPECT_TRUE(rejects(against(three(), {1, 1}, of_the_plane)));
}

class LargeStepInSpace : public LeaningBox {
 protected:
  static constexpr std::size_t per_axis = 3, per_wall = per_axis * per_axis;

  // As claimed wherever it comes from: it is read off the way back.
  double density(const PrimaryLarge& large, const Path<W>& z) const {
    Rng random(1, Purpose::test, 20);
    Path<W> y(space_.max_vertices());
    for (;;) {
      const Proposed proposed = large.propose(space_, z, y, random);
      if (const Proposal* p = std::get_if<Proposal>(&proposed)) return p->reverse.value();
    }
  }
  // Of two vertices, by the cells of both; `factor` spoils the claim.
  Decision against(double factor) const {
    const PrimaryLarge large(space_.max_vertices());
    const Path<W> x = two();
    Path<W> y(space_.max_vertices());
    std::vector<double> observed(per_wall * per_wall + 1), expected(observed.size());
    Rng random(2, Purpose::test, 21);
    for (int i = 0; i < proposals; ++i) {
      const Proposed proposed = large.propose(space_, x, y, random);
      const bool counts = std::holds_alternative<Proposal>(proposed) && y.size() == 2;
      ++observed[counts ? cell(y[0], per_axis) * per_wall + cell(y[1], per_axis)
                        : observed.size() - 1];
    }
    Path<W> z = x;
    const auto claim = [&](const std::array<double, 4>& u) {
      put(z, 0, light_wall, {u[0], u[1]});
      put(z, 1, sensor_wall, {u[2], u[3]});
      if (!complete(z)) return 0.0;
      weigh(space_, z);
      return factor * sheet(light_wall).measure() * sheet(sensor_wall).measure() *
             density(large, z);
    };
    double total = 0;
    for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
      const Box<2> first = box(i / per_wall, per_axis), second = box(i % per_wall, per_axis);
      const Box<4> both{{first.low[0], first.low[1], second.low[0], second.low[1]},
                        {first.high[0], first.high[1], second.high[0], second.high[1]}};
      total += expected[i] = proposals * gauss_integral<4>(claim, both, gauss_rule(3));
    }
    expected.back() = proposals - total;
    return chi_square_test(observed, expected, usual_false_alarm);
  }
};

TEST_F(LargeStepInSpace, ProposesTwoVerticesWithTheDensityThatItClaims) {
  EXPECT_TRUE(passes(against(1)));
  EXPECT_TRUE(rejects(against(1.1)));
}

}  // namespace
}  // namespace wander::test::space_density_test
