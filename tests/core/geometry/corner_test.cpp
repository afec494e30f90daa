// Rooms are closed: no ray from inside a polygon, or from a point on its walls, gets out, even when
// it is aimed at a corner to the last bit.  A wall's own end is nearer than its points are exact
// within a few roundings; light that starts there is left out, and nothing else is.
#include <gtest/gtest.h>

#include "core/dimension.h"
#include "core/geometry/bvh.h"
#include "tests/core/geometry/polygons.h"

namespace wander::test {
namespace {

using RoomRay = Ray<Flatland>;

struct Room {
  std::vector<Wall2> walls;
  Corner center{0};
  double scale = 1;
  double core = 0.01;  // points this near the centre see every corner

  // How exactly a point of this wall is known.
  static double rounding(const Wall2& wall) {
    double most = 0;
    for (const Corner p : {wall.from, wall.to})
      most = std::max({most, std::abs(p.x), std::abs(p.y)});
    return std::numeric_limits<double>::epsilon() * most;
  }
};

Room make_room(Generator& g) {
  const int count = 4 + static_cast<int>(40 * g.uniform() * g.uniform());
  const double kind = g.uniform();
  Room room{kind < 0.25   ? convex_polygon(g, count)
            : kind < 0.5  ? uneven_polygon(g, count)
            : kind < 0.75 ? spiky_polygon(g, count)
                          : overlapping_polygon(g, count)};
  room.core = kind < 0.75 ? 0.002 : 0;
  if (g.uniform() < 0.5) return room;
  room.center = Corner(g.normal(), g.normal()) * std::pow(10, 3 * g.uniform());
  room.scale = std::pow(10, 4 * g.uniform() - 2);
  room.walls = moved(room.walls, room.center, room.scale);
  return room;
}

// Within 1e-17 … 1e-6 of the origin, or on it.
Corner nudge(Generator& g) {
  if (g.uniform() < 0.2) return Corner(0);
  return std::pow(10, -6 - 11 * g.uniform()) * Corner(2 * g.uniform() - 1, 2 * g.uniform() - 1);
}

// Uniform, or as near an end of the unit interval as numbers go.
double position(Generator& g) {
  const double kind = g.uniform();
  if (kind < 0.6) return g.uniform();
  const double tiny = std::pow(10, -16 * g.uniform());
  return kind < 0.8 ? tiny : std::min(1 - tiny, 1 - 0x1p-53);
}

class RoomRays {
 public:
  RoomRays(const Room& room, Generator& g) : room_(room), g_(g) {
    for (const Wall2& wall : room.walls)
      shapes_.emplace_back(Segment<Flatland>(wall.from, wall.to));
  }

  const std::vector<Shape<Flatland>>& shapes() const { return shapes_; }

  // None when the ray would not start into the room, or starts in the last bits of a corner.
  std::optional<RoomRay> draw() {
    const double kind = g_.uniform();
    if (kind < 0.25) return aimed_from_inside();
    if (kind < 0.5) return scattered();
    if (kind < 0.75) return aimed_along_own_wall();
    return aimed_from_wall();
  }

 private:
  Corner any_corner() {
    return room_.walls[static_cast<std::size_t>(g_.uniform() * double(room_.walls.size()))].from;
  }

  RoomRay aimed_from_inside() {
    const double reach = room_.core * room_.scale;
    const Corner origin = room_.center + reach * Corner(g_.uniform() - 0.5, g_.uniform() - 0.5);
    return {.origin = origin, .direction = any_corner() + room_.scale * nudge(g_) - origin};
  }
  // As light is scattered: through the local frame, up to the most grazing sample there is.
  std::optional<RoomRay> scattered() {
    RoomRay ray = start();
    const auto local = Dimension<2>::cosine_sample(std::array<double, 1>{position(g_)});
    ray.direction = Frame<2, double>{normal_}.to_world(local);
    return checked(ray);
  }
  std::optional<RoomRay> aimed_from_wall() {
    RoomRay ray = start();
    ray.direction = any_corner() + room_.scale * nudge(g_) - ray.origin;
    return checked(ray);
  }
  std::optional<RoomRay> aimed_along_own_wall() {
    RoomRay ray = start();
    const Wall2& wall = room_.walls[static_cast<std::size_t>(ray.from.shape)];
    const Corner end = g_.uniform() < 0.5 ? wall.from : wall.to;
    ray.direction = end + normal_ * room_.scale * std::abs(nudge(g_).x) - ray.origin;
    return checked(ray);
  }

  RoomRay start() {
    const double wall = g_.uniform() * static_cast<double>(room_.walls.size());
    const auto id = static_cast<ShapeId>(wall);
    const auto point =
        std::get<Segment<Flatland>>(shapes_[static_cast<std::size_t>(id)]).sample({position(g_)});
    normal_ = point.normal;
    return {.origin = point.position, .direction = Corner(0), .from = id};
  }
  std::optional<RoomRay> checked(const RoomRay& ray) const {
    const auto id = static_cast<std::size_t>(ray.from.shape);
    const Wall2& wall = room_.walls[id];
    const Corner next = room_.walls[(id + 1) % room_.walls.size()].from;  // the foot of a T
    const double cosine = glm::dot(glm::normalize(ray.direction), normal_);
    if (!(cosine > 0) || glm::dot(next - ray.origin, wall.to - wall.from) < 0) return {};
    const double end =
        std::min({glm::length(ray.origin - wall.from), glm::length(ray.origin - wall.to),
                  glm::length(ray.origin - next)});
    if (end * cosine < 8 * Room::rounding(wall)) return {};
    return ray;
  }

  const Room& room_;
  Generator& g_;
  std::vector<Shape<Flatland>> shapes_;
  Flatland::Direction normal_{};
};

struct Escapes {
  int rays = 0, escaped = 0;
};

// `hits(room rays' shapes)` makes the function that says whether a ray hits anything.
template <class MakeHits>
Escapes count_escapes(std::uint64_t seed, int rooms, int rays, MakeHits make_hits) {
  Escapes escapes;
  Generator g(seed);
  for (int i = 0; i < rooms; ++i) {
    const Room room = make_room(g);
    RoomRays draws(room, g);
    const auto hits = make_hits(room, draws.shapes());
    for (int k = 0; k < rays; ++k) {
      const auto ray = draws.draw();
      if (!ray) continue;
      ++escapes.rays;
      if (!hits(*ray)) ++escapes.escaped;
    }
  }
  return escapes;
}

TEST(Corners, LetNoLightOut) {
  const auto hierarchy = [](const Room&, const std::vector<Shape<Flatland>>& shapes) {
    return [bvh = Bvh<Flatland>(shapes)](const RoomRay& ray) { return bool(bvh.closest(ray)); };
  };
  const Escapes escapes = count_escapes(1, 4000, 2000, hierarchy);
  EXPECT_GT(escapes.rays, 5'000'000);
  EXPECT_EQ(escapes.escaped, 0);
}

// Controls: the intersection as it is often written, from the parameter along the wall.
template <class Inside>
auto naive(Inside inside) {
  return [inside](const Room& room, const std::vector<Shape<Flatland>>&) {
    return [&room, inside](const RoomRay& ray) {
      for (std::size_t i = 0; i < room.walls.size(); ++i) {
        if (ray.from == static_cast<ShapeId>(i)) continue;
        const Corner along = room.walls[i].to - room.walls[i].from,
                     to = room.walls[i].from - ray.origin;
        const double det = cross(ray.direction, along);
        const double u = cross(to, ray.direction) / det, distance = cross(to, along) / det;
        if (inside(u) && distance > 0) return true;
      }
      return false;
    };
  };
}

TEST(Corners, LeakWhenEndsAreCutOffByAnEpsilon) {
  const auto strict = [](double u) { return u > 1e-9 && u < 1 - 1e-9; };
  EXPECT_GT(count_escapes(2, 20, 2000, naive(strict)).escaped, 100);
}

TEST(Corners, LeakWhenEachWallComputesItsOwnEnd) {
  const auto closed_interval = [](double u) { return u >= 0 && u <= 1; };
  EXPECT_GT(count_escapes(3, 200, 2000, naive(closed_interval)).escaped, 10);
}

// A connection from inside to a point outside crosses a wall, corner or not.
TEST(Corners, BlockConnectionsThroughThem) {
  Generator g(4);
  for (int i = 0; i < 500; ++i) {
    const Room room = make_room(g);
    RoomRays draws(room, g);
    const Bvh<Flatland> bvh(draws.shapes());
    for (const Wall2& wall : room.walls)
      for (int k = 0; k < 20; ++k) {
        const Corner aim = wall.from + room.scale * nudge(g);
        const RoomRay ray{
            .origin = room.center, .direction = 300.0 * (aim - room.center), .limit = 1};
        ASSERT_TRUE(bvh.any(ray));
      }
  }
}

// Where a curve continues a wall the two compute their common end each in its own way: a ray may
// slip through within a few roundings of it, and nowhere else.
TEST(Curves, LetNoLightOutBesideTheirEnds) {
  Generator g(5);
  constexpr double quarter = std::numbers::pi / 2;
  for (int i = 0; i < 300; ++i) {
    const double r = 0.1 + g.uniform(), half = 1 + g.uniform();
    const Corner c(g.normal(), g.normal());
    const Corner ends[] = {c + Corner(-half, -r), c + Corner(half, -r), c + Corner(half, r),
                           c + Corner(-half, r)};
    using Curve = Arc<Flatland>;
    const std::vector<Shape<Flatland>> stadium{
        Segment<Flatland>(ends[0], ends[1]),
        Curve(c + Corner(half, 0), r, -quarter, 2 * quarter, Curve::Facing::inward),
        Segment<Flatland>(ends[2], ends[3]),
        Curve(c + Corner(-half, 0), r, quarter, 2 * quarter, Curve::Facing::inward)};
    const Bvh<Flatland> bvh(stadium);
    for (int k = 0; k < 3000; ++k) {
      const Corner origin = c + Corner((2 * g.uniform() - 1) * half, (1.8 * g.uniform() - 0.9) * r);
      const double angle = 4 * quarter * g.uniform(), aside = std::pow(10, -14 + 8 * g.uniform());
      const Corner aim = ends[k % 4] + aside * Corner(std::cos(angle), std::sin(angle));
      const Corner across = glm::normalize(left_of(aim - origin));
      if (std::abs(glm::dot(across, aim - ends[k % 4])) < 1e-14) continue;
      ASSERT_TRUE(bvh.closest({.origin = origin, .direction = aim - origin}));
    }
  }
}

}  // namespace
}  // namespace wander::test
