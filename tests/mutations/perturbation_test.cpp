// What the perturbations do to a path: only a stretch of it moves, its class stays, what was kept
// is the same bit for bit, what is new is measured as if it were fresh; and the way back is one
// move, with the densities exchanged.  Random paths of every room, in the plane and in space.
#include <gtest/gtest.h>

#include "mutations/catalogue.h"
#include "tests/support/claimed_density.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/path_equality.h"
#include "tests/support/perturbation_rooms.h"
#include "tests/support/space_box.h"
#include "tests/support/test_scenes.h"

namespace wander::test::perturbation_test {
namespace {

constexpr PerturbationRange wide{.position{1e-3, 0.4}, .angle{1e-3, 0.7}};

// Calls check(x, y, claim, numbers) for successful moves of random paths; says how many.
template <class W, class Mutation, class Check>
int for_moves(const Transport<W>& space, const Mutation& mutation, const Check& check,
              int moves = 400) {
  Starts<Transport<W>> starts(space, 7);
  Rng random(7, Purpose::test, 62);
  Path<W> y(space.max_vertices());
  int checked = 0;
  for (std::uint64_t i = 0; i < 20'000 && checked < moves; ++i) {
    if (!(starts.draw(i) > 0)) continue;
    const Path<W>& x = starts.path();
    if (!(mutation.applicability(space, x) > 0)) continue;
    random.start(i);
    Recording<Rng> numbers{random};
    const Proposed proposed = mutation.propose(space, x, y, numbers);
    const Proposal* claim = std::get_if<Proposal>(&proposed);
    if (!claim) continue;
    check(x, std::as_const(y), *claim, std::as_const(numbers.drawn));
    if (::testing::Test::HasFatalFailure()) return checked;
    ++checked;
  }
  return checked;
}

// ---- what moves and what stays

bool any(Event) { return true; }

// Vertices beyond the neighbours of what moved are the same; of the neighbours' neighbours, what is
// sampled from the moved side may differ.
template <class W>
void expect_same_outside(const Path<W>& x, const Path<W>& y) {
  const std::vector<int> moved = moved_vertices(x, y, any);
  ASSERT_FALSE(moved.empty());
  const int low = moved.front(), high = moved.back();
  ASSERT_EQ(high - low + 1, static_cast<int>(moved.size())) << "not one stretch";
  for (int i = 0; i < x.size(); ++i) {
    if (i >= low && i <= high) continue;
    EXPECT_EQ(x[i].place.normal, y[i].place.normal);
    EXPECT_EQ(x[i].place.shape, y[i].place.shape);
    if (i == low - 1 || i == high + 1) continue;
    Vertex<W> kept = y[i];
    if (i == low - 2) kept.from_sensor = x[i].from_sensor;
    if (i == high + 2) kept.from_light = x[i].from_light;
    if (i + 1 == x.size()) {  // no edge belongs to it
      kept.place.to_sensor = x[i].place.to_sensor;
      kept.geometry = x[i].geometry;
    }
    EXPECT_TRUE(identical(x[i], kept)) << "vertex " << i << " of " << path_class(x);
  }
}

// Measured anew from its places alone, edges and values are what the mutation wrote.
template <class W>
void expect_measured(const Transport<W>& space, const Path<W>& y) {
  Path<W> fresh(space.max_vertices());
  fresh = y;
  for (int i = 0; i + 1 < y.size(); ++i) {
    const auto edge = y[i + 1].place.position - y[i].place.position;
    const auto direction = glm::normalize(edge);
    ASSERT_LT(glm::length(direction - y[i].place.to_sensor), 1e-9);
    const double cosines = std::abs(glm::dot(direction, y[i].place.normal) *
                                    glm::dot(direction, y[i + 1].place.normal));
    const double geometry = cosines / std::pow(glm::length(edge), W::dimension - 1);
    ASSERT_NEAR(y[i].geometry / geometry, 1, 1e-6);
  }
  ASSERT_EQ(evaluate(space, fresh, 0, y.size() - 1), Reason::none);
  for (int i = 0; i < y.size(); ++i) EXPECT_TRUE(identical(fresh[i], y[i])) << path_class(y);
}

template <class W, class Mutation>
int expect_one_stretch_moves(const Transport<W>& space, const Mutation& mutation) {
  return for_moves(
      space, mutation,
      [&](const Path<W>& x, const Path<W>& y, const Proposal&, const std::vector<double>&) {
        EXPECT_EQ(path_class(x), path_class(y));
        expect_same_outside(x, y);
        expect_measured(space, y);
      });
}

// ---- there and back

// Where the walk of a mutation begins, and where it goes.
struct Walk {
  Toward toward;
  int first;
};
template <class Space, class W>
Walk walk_of(const Space&, const Lens&, const Path<W>& x) {
  return {Toward::light, x.size() - 1};
}
template <class Space, class W>
Walk walk_of(const Space&, const Multichain&, const Path<W>& x) {
  return {Toward::light, x.size() - 1};
}
template <class Space, class W>
Walk walk_of(const Space&, const Caustic&, const Path<W>& x) {
  const int end = x.size() - 1;
  const bool hits = end == 1 || is_specular(x[end - 1].event);
  return {Toward::sensor, next_not_specular(x, hits ? end : end - 1, Toward::light)};
}

// The number that turns y's direction back to x's: the other side; the azimuth that x has from y.
template <class W>
double side_back(const Transport<W>& space, const Path<W>& x, const Path<W>& y, int i,
                 Toward toward, double side) {
  if (W::dimension == 2 || space.is_camera(x[i])) return std::fmod(side + 0.5, 1);
  const auto local = Frame<W::dimension, double>{space.direction(y, i, toward)}.to_local(
      space.direction(x, i, toward));
  const double turn = std::atan2(local[1], local[0]) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

// The numbers of the move y → x that undoes the move x → y: the same distances, the other sides.
template <class W>
std::vector<double> numbers_back(const Transport<W>& space, const Path<W>& x, const Path<W>& y,
                                 Walk walk, std::vector<double> numbers) {
  std::size_t k = 1;
  int i = walk.first;
  if ((i == 0 || i == x.size() - 1) && !space.is_pinhole(x[i])) {
    numbers[k] = std::fmod(numbers[k] + 0.5, 1);
    k += 2;
  }
  for (; k < numbers.size(); k += 2, i = next_not_specular(x, i, walk.toward))
    numbers[k] = side_back(space, x, y, i, walk.toward, numbers[k]);
  return numbers;
}

// Curved glass magnifies rounding: a few moves in a hundred come back less exactly than 1e-9.
struct Return {
  int exact = 0, all = 0;
};

template <class W, class Mutation>
Return go_there_and_back(const Transport<W>& space, const Mutation& mutation) {
  Return result;
  for_moves(space, mutation,
            [&](const Path<W>& x, const Path<W>& y, const Proposal& claim,
                const std::vector<double>& numbers) {
              const auto back =
                  move_by(space, mutation, y,
                          numbers_back(space, x, y, walk_of(space, mutation, x), numbers));
              ASSERT_TRUE(back) << path_class(x);
              double off = 0;
              for (int i = 0; i < x.size(); ++i) {
                const auto distance = glm::length(back->y[i].place.position - x[i].place.position);
                off = std::max(off, static_cast<double>(distance));
                ASSERT_EQ(back->y[i].place.shape, x[i].place.shape);
              }
              off = std::max(off, std::abs((claim.forward / back->claim.reverse).value() - 1));
              off = std::max(off, std::abs((claim.reverse / back->claim.forward).value() - 1));
              ASSERT_LT(off, 1e-5) << path_class(x);
              ++result.all;
              result.exact += off < 1e-9 ? 1 : 0;
            });
  return result;
}

template <class W, class Mutation>
void expect_return(const Transport<W>& space, const Mutation& mutation, int fewest) {
  const Return result = go_there_and_back(space, mutation);
  EXPECT_GE(result.all, fewest) << Mutation::name;
  EXPECT_GE(result.exact, 0.9 * result.all) << Mutation::name;
}

template <class W>
void expect_moves(const Transport<W>& space, int fewest_multichain) {
  EXPECT_GE(expect_one_stretch_moves(space, Lens{wide}), 100);
  EXPECT_GE(expect_one_stretch_moves(space, Caustic{wide}), 100);
  EXPECT_GE(expect_one_stretch_moves(space, Multichain{wide}), fewest_multichain);
}
template <class W>
void expect_returns(const Transport<W>& space, int fewest_multichain) {
  expect_return(space, Lens{wide}, 100);
  expect_return(space, Caustic{wide}, 100);
  expect_return(space, Multichain{wide}, fewest_multichain);
}

class InThePlane : public ::testing::TestWithParam<NamedRoom> {
 protected:
  FlatScene scene_ = build(GetParam().make());
  Transport<Flatland> space_{*scene_, Roulette::off};
  // Of moves that the multi-chain perturbation must find here.
  int fewest_ = Multichain::left_out(requires_of(GetParam().make())).empty() ? 15 : 0;
};
INSTANTIATE_TEST_SUITE_P(Rooms, InThePlane, ::testing::ValuesIn(perturbation_rooms()),
                         [](const auto& test) { return test.param.name; });

TEST_P(InThePlane, OnlyAStretchOfAPathMoves) { expect_moves(space_, fewest_); }
TEST_P(InThePlane, EveryMoveCanBeUndone) { expect_returns(space_, fewest_); }

// The radius of a lens; negative: the sensor is the floor.
class InSpace : public ::testing::TestWithParam<double> {
 protected:
  Scene<Spaceland> scene_{GetParam() < 0 ? space_box() : space_box_by_camera(GetParam())};
  Transport<Spaceland> space_{scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Sensors, InSpace, ::testing::Values(-1.0, 0.0, 0.05));

TEST_P(InSpace, OnlyAStretchOfAPathMoves) { expect_moves(space_, 15); }
TEST_P(InSpace, EveryMoveCanBeUndone) { expect_returns(space_, 15); }

// ---- the caustic perturbation is the lens perturbation seen from the other end

description::Scene with_ends(std::size_t sensor, std::size_t light) {
  description::Scene scene;
  scene.max_vertices = 4;
  const description::Quantity grey{{0.7, 0.7, 0.7}, false};
  scene.materials = {{"wall", description::Diffuse{grey}}, {"mirror", description::Mirror{grey}}};
  const std::array<description::Coordinates, 9> corners{
      {{0, 0}, {0.3, 0}, {0.8, 0}, {1, 0}, {1.1, 0.9}, {0.8, 0.95}, {0.4, 1.02}, {0, 1.1}, {0, 0}}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    description::Shape& wall = scene.shapes.emplace_back();
    wall.kind = description::Segment{corners[i], corners[i + 1]};
    wall.material = i == 3 ? 1 : 0;
  }
  scene.shapes[sensor].sensor = description::Sensor{{4}};
  scene.shapes[light].light = description::Light{{{1, 1, 1}, false}};
  return scene;
}

Path<Flatland> reversed(const Path<Flatland>& x, int max_vertices) {
  const int n = x.size();
  Path<Flatland> y(max_vertices);
  y.resize(n);
  for (int i = 0; i < n; ++i) {
    y[i] = x[n - 1 - i];
    if (y[i].event == Event::emission || y[i].event == Event::detection)
      y[i].event = i == 0 ? Event::emission : Event::detection;
    if (i + 1 == n) continue;
    y[i].place.to_sensor = -x[n - 2 - i].place.to_sensor;
    y[i].geometry = x[n - 2 - i].geometry;
  }
  return y;
}

// Light and sensor exchanged, the lens perturbation of a path … z d S* E makes of the same numbers
// what the caustic perturbation makes of E S* d z: the same vertices, densities and acceptance.
TEST(Reciprocity, TurnsTheLensPerturbationIntoTheCausticPerturbation) {
  using Flat = Transport<Flatland>;
  const FlatScene scene = build(with_ends(1, 5)), exchanged = build(with_ends(5, 1));
  const Flat space(*scene, Roulette::off), other(*exchanged, Roulette::off);
  int compared = 0, with_mirror = 0;
  for_moves(
      space, Lens{wide},
      [&](const Path<Flatland>& x, const Path<Flatland>& y, const Proposal& claim,
          const std::vector<double>& numbers) {
        const std::string letters = path_class(x);
        if (letters != "LDE" && letters != "LDSE" && letters != "LE" && letters != "LSE") return;
        Path<Flatland> back = reversed(x, 4);
        ASSERT_EQ(evaluate(other, back, 0, x.size() - 1), Reason::none);
        const auto moved = move_by(other, Caustic{wide}, back, numbers);
        ASSERT_TRUE(moved) << letters;
        const Path<Flatland> z = reversed(moved->y, 4);
        for (int i = 0; i < x.size(); ++i)
          ASSERT_LT(glm::length(z[i].place.position - y[i].place.position), 1e-12) << letters;
        EXPECT_NEAR((moved->claim.forward / claim.forward).value(), 1, 1e-9) << letters;
        EXPECT_NEAR((moved->claim.reverse / claim.reverse).value(), 1, 1e-9) << letters;
        EXPECT_NEAR(acceptance(contribution(back), moved->claim.forward, contribution(moved->y),
                               moved->claim.reverse),
                    acceptance(contribution(x), claim.forward, contribution(y), claim.reverse),
                    1e-9)
            << letters;
        ++compared;
        with_mirror += letters[x.size() - 2] == 'S' ? 1 : 0;
      },
      2000);
  EXPECT_GT(compared, 500);
  EXPECT_GT(with_mirror, 50);
}

}  // namespace
}  // namespace wander::test::perturbation_test
