// The density that the bidirectional mutation claims, for paths with one new vertex, against the
// histogram of what it proposes (density_test.cpp says how).  The label, what is kept and how many
// vertices are new, is part of the transition: each label has a histogram of its own, and all
// others share a cell.  False alarms: 1e-9 per χ².
#include <gtest/gtest.h>

#include "mutations/bidirectional.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"
#include "tests/support/smooth_room.h"
#include "tests/support/wrong_twins.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// What was kept and how many vertices came anew.
struct Label {
  Bidirectional::Kept kept;
  int added;

  bool operator==(const Label& other) const {
    return kept.light == other.kept.light && kept.sensor == other.kept.sensor &&
           added == other.added;
  }
};

// Proposals from x with this label, by the wall and position of their one new vertex, against
// density(wall, position), per unit of length.
template <class Density>
Decision one_new_vertex(const Flat& space, const Scene<W>& scene, const Path<W>& x, Label label,
                        std::size_t cells, const Density& density) {
  const auto segment = [&](std::size_t w) {
    return std::get<Segment<W>>(scene.shape(static_cast<ShapeId>(w)));
  };
  std::vector<double> observed(cells * wall_count + 1), expected(observed.size());
  Path<W> y(space.max_vertices());
  Rng random(4, Purpose::test, 23);
  constexpr int proposals = 300'000;
  const int fresh = label.kept.light;  // index of the new vertex
  for (int i = 0; i < proposals; ++i) {
    const Proposed proposed = Bidirectional{}.propose(space, x, y, random);
    const auto kept = kept_vertices(x, y);
    const Label made{kept, y.size() - kept.light - kept.sensor};
    std::size_t cell = observed.size() - 1;
    if (std::holds_alternative<Proposal>(proposed) && made == label) {
      const auto wall = static_cast<std::size_t>(y[fresh].place.shape);
      const double u = segment(wall).parameter(y[fresh].place.position)[0];
      cell = wall * cells + static_cast<std::size_t>(u * static_cast<double>(cells));
    }
    ++observed[cell];
  }
  double total = 0;
  for (std::size_t i = 0; i < cells * wall_count; ++i) {
    const std::size_t wall = i / cells;
    const double low = static_cast<double>(i % cells) / static_cast<double>(cells);
    const auto along = [&](double u) {
      return segment(wall).measure() * density(static_cast<ShapeId>(wall), u);
    };
    const double mass =
        integral(along, low, low + 1 / static_cast<double>(cells), {.absolute = 1e-9, .depth = 12});
    total += expected[i] = proposals * mass;
  }
  expected.back() = proposals - total;
  return chi_square_test(observed, expected, usual_false_alarm);
}

class NewVertex : public SmoothRoom {
 protected:
  // The claim for proposals that keep these vertices of x and add one.
  Decision claimed(const Path<W>& x, Bidirectional::Kept kept) const {
    return against(x, kept,
                   [](const Path<W>&, const Path<W>&, Bidirectional::Kept) { return 1.0; });
  }
  // The same for a claim that is wrong by a factor.
  template <class Flaw>
  Decision against(const Path<W>& x, Bidirectional::Kept kept, const Flaw& flaw) const {
    const int n = kept.light + kept.sensor + 1, d = x.size() - kept.light - kept.sensor;
    Path<W> z(space_.max_vertices());
    z.resize(n);
    z.copy(x, 0, kept.light, 0);
    z.copy(x, x.size() - kept.sensor, kept.sensor, n - kept.sensor);
    const auto density = [&](ShapeId wall, double u) {
      if (kept.light == 0 && wall != light_wall) return 0.0;
      if (kept.sensor == 0 && wall != sensor_wall) return 0.0;
      put(z, kept.light, wall, u);
      if (!complete(z)) return 0.0;
      using B = Bidirectional;
      const double choice = B::delete_probability(x.size(), d, kept) *
                            B::add_probability(kept, d, 1, space_.max_vertices());
      return flaw(x, z, kept) * (choice * B::added_density(space_, z, kept, 1).value());
    };
    return one_new_vertex(space_, *scene_, x, {kept, 1}, 10, density);
  }
  Path<W> two() const { return path({{light_wall, 0.4}, {sensor_wall, 0.3}}); }
  Path<W> three() const { return path({{light_wall, 0.4}, {7, 0.6}, {sensor_wall, 0.3}}); }
};

TEST_F(NewVertex, InTheMiddleHasTheDensityThatTheBidirectionalMutationClaims) {
  EXPECT_TRUE(passes(claimed(three(), {1, 1})));
}
TEST_F(NewVertex, InsertedHasTheDensityThatTheBidirectionalMutationClaims) {
  EXPECT_TRUE(passes(claimed(two(), {1, 1})));
}
TEST_F(NewVertex, OnTheLightHasTheDensityThatTheBidirectionalMutationClaims) {
  EXPECT_TRUE(passes(claimed(two(), {0, 1})));
  EXPECT_TRUE(passes(claimed(three(), {0, 2})));
}
TEST_F(NewVertex, OnTheSensorHasTheDensityThatTheBidirectionalMutationClaims) {
  EXPECT_TRUE(passes(claimed(two(), {1, 0})));
  EXPECT_TRUE(passes(claimed(three(), {2, 0})));
}

// The claims above are put together here; the proposal must make the same ones.
TEST_F(NewVertex, ThereAndBackTheSameDensitiesAreClaimed) {
  Rng random(5, Purpose::test, 24);
  const Path<W> x = three();
  Path<W> y(space_.max_vertices());
  int checked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Proposed proposed = Bidirectional{}.propose(space_, x, y, random);
    const Proposal* p = std::get_if<Proposal>(&proposed);
    const auto kept = kept_vertices(x, y);
    const int common = kept.light + kept.sensor, d = x.size() - common, a = y.size() - common;
    if (!p || (d == 0 && a == 0)) continue;
    using B = Bidirectional;
    const auto claim = [&](const Path<W>& from, const Path<W>& to, int deleted, int added) {
      return (Scaled(B::delete_probability(from.size(), deleted, kept) *
                     B::add_probability(kept, deleted, added, space_.max_vertices())) *
              B::added_density(space_, to, kept, added))
          .value();
    };
    ASSERT_NEAR(p->forward.value() / claim(x, y, d, a), 1, 1e-12);
    ASSERT_NEAR(p->reverse.value() / claim(y, x, a, d), 1, 1e-12);
    ++checked;
  }
  EXPECT_GT(checked, 5000);
}

TEST_F(NewVertex, WithASingleSplitIsCaught) {
  const auto single = [&](const Path<W>&, const Path<W>& z, Bidirectional::Kept kept) {
    const double sum = 2 * Bidirectional::added_density(space_, z, kept, 1).value();
    return 2 * static_cast<double>(z[kept.light].from_light) / sum;
  };
  EXPECT_TRUE(rejects(against(three(), {1, 1}, single)));
}
TEST_F(NewVertex, WithoutItsGeometryTermOrAProbabilityIsCaught) {
  const auto geometry = [](const Path<W>&, const Path<W>& z, Bidirectional::Kept) {
    return 1 / z[0].geometry;
  };
  EXPECT_TRUE(rejects(against(three(), {1, 1}, geometry)));
  const auto addition = [](const Path<W>&, const Path<W>&, Bidirectional::Kept kept) {
    return 1 / Bidirectional::add_probability(kept, 1, 1, 4);
  };
  EXPECT_TRUE(rejects(against(three(), {1, 1}, addition)));
}

}  // namespace
}  // namespace wander::test
