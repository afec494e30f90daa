// Textures: what a picture says between its texels and beyond them, where surfaces have it, and what it
// makes of films.  False-alarm rate 1e-9 per decision.
#include "core/texture.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/path_sampler.h"
#include "scenes/format/build_scene.h"
#include "tests/core/film_sampling.h"
#include "tests/support/coloured_box.h"
#include "tests/support/expect.h"

namespace wander::test::texture_test {
namespace {

using Uv = std::array<double, 2>;
using Colour = std::array<double, 3>;
using Shared = std::shared_ptr<const Texture>;

// Rows from the top: 1 2 above 3 5, in tenths.
Texture four() { return Texture({2, 2, 1, {0, 1, 2, 3}, {}, {0.1, 0.2, 0.3, 0.5}}); }

double grey_at(const Texture& texture, Uv uv) {
  const Colour colour = texture.at(uv);
  EXPECT_EQ(colour[0], colour[1]);
  EXPECT_EQ(colour[0], colour[2]);
  return colour[0];
}

TEST(Textures, HaveTheirTexelsAtTheCentresOfSquaresAndTheirTopRowOnTop) {
  const Texture texture = four();
  EXPECT_EQ(grey_at(texture, {0.25, 0.75}), 0.1);
  EXPECT_EQ(grey_at(texture, {0.75, 0.75}), 0.2);
  EXPECT_EQ(grey_at(texture, {0.25, 0.25}), 0.3);
  EXPECT_EQ(grey_at(texture, {0.75, 0.25}), 0.5);
  EXPECT_FALSE(texture.is_coloured());
}

TEST(Textures, AreBilinearInBetween) {
  const Texture texture = four();
  EXPECT_DOUBLE_EQ(grey_at(texture, {0.5, 0.75}), 0.15);
  EXPECT_DOUBLE_EQ(grey_at(texture, {0.25, 0.5}), 0.2);
  EXPECT_DOUBLE_EQ(grey_at(texture, {0.5, 0.5}), 0.275);
  // A quarter of the way to the right, and a tenth of it down.
  EXPECT_DOUBLE_EQ(grey_at(texture, {0.375, 0.7}),
                   0.9 * (0.75 * 0.1 + 0.25 * 0.2) + 0.1 * (0.75 * 0.3 + 0.25 * 0.5));
}

TEST(Textures, AreRepeated) {
  const Texture texture = four();
  // On the edges, half of what is on the other side.
  EXPECT_DOUBLE_EQ(grey_at(texture, {0, 0.75}), 0.15);
  EXPECT_DOUBLE_EQ(grey_at(texture, {1, 0.75}), 0.15);
  EXPECT_DOUBLE_EQ(grey_at(texture, {0.125, 0.75}), 0.75 * 0.1 + 0.25 * 0.2);
  EXPECT_DOUBLE_EQ(grey_at(texture, {0.75, 1}), 0.35);
  for (const Uv uv : {Uv{0.375, 0.625}, Uv{0.125, 0.875}})
    for (const int turns : {-3, -1, 1, 2}) {
      EXPECT_NEAR(grey_at(texture, {uv[0] + turns, uv[1]}), grey_at(texture, uv), 1e-15);
      EXPECT_NEAR(grey_at(texture, {uv[0], uv[1] + turns}), grey_at(texture, uv), 1e-15);
    }
  EXPECT_DOUBLE_EQ(grey_at(texture, {-1e-30, 0.75}), 0.15);
  EXPECT_GT(grey_at(texture, {NAN, INFINITY}), 0);  // of a triangle without area
}

TEST(Textures, HaveAWidthAndAHeightAndChannels) {
  const Texture wide(
      {3, 1, 3, {}, {0, 1, 2, 3, 4, 5, 6, 7, 8}, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8}});
  EXPECT_TRUE(wide.is_coloured());
  EXPECT_EQ(wide.at({0.5, 0.3}), (Colour{0.3, 0.4, 0.5}));
  EXPECT_EQ(wide.at({1.0 / 6, 0.9}), (Colour{0, 0.1, 0.2}));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_DOUBLE_EQ(wide.mean()[k], 0.3 + 0.1 * static_cast<double>(k));
  EXPECT_DOUBLE_EQ(four().mean()[2], 0.275);
}

// ---- on surfaces

using W = SpacelandColour;
using Point = W::Point;

TEST(TextureCoordinates, RunAlongTheEdgesOfAParallelogram) {
  const Parallelogram<W> sheet({1, 1, 0}, {2, 0, 0}, {1, 0, 4});
  const Uv uv =
      sheet.texture_coordinates(Point(1, 1, 0) + 0.25 * Point(2, 0, 0) + 0.75 * Point(1, 0, 4), {});
  EXPECT_NEAR(uv[0], 0.25, 1e-15);
  EXPECT_NEAR(uv[1], 0.75, 1e-15);
}

TEST(TextureCoordinates, AreMixedBetweenTheCornersOfATriangle) {
  Triangles mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
  mesh.corners = {{0, 1, 2}, {1, 3, 2}};
  mesh.coordinates = {{0, 0}, {4, 0}, {0, 8}, {1, 1}};
  const auto expect_at = [&](Point p, std::int32_t triangle, Uv expected) {
    const Uv uv = Mesh<W>(std::make_shared<const Triangles>(mesh), SurfaceRole::passive)
                      .texture_coordinates(p, triangle);
    EXPECT_NEAR(uv[0], expected[0], 1e-14);
    EXPECT_NEAR(uv[1], expected[1], 1e-14);
  };
  expect_at({0.5, 1, 0}, 0, {1, 4});
  expect_at({2, 2, 0}, 1, {1, 1});
  expect_at({1, 1, 0}, 1, {2, 4});
  mesh.coordinate_corners = {{3, 3, 1}, {0, 1, 2}};
  expect_at({0, 2, 0}, 0, {4, 0});
  expect_at({2, 2, 0}, 1, {4, 0});
}

// ---- films

description::Quantity said_by(Shared texture) {
  return {texture->mean(), texture->is_coloured(), texture};
}

description::Quantity flat(Colour colour) {
  return said_by(std::make_shared<const Texture>(
      Texture::Picture{1, 1, 3, {0, 1, 2}, {}, {colour[0], colour[1], colour[2]}}));
}

// The box, with its balls and mirrors, and textures that are as its walls were.
description::Scene flatly_textured_box() {
  description::Scene scene = coloured_box();
  for (auto& material : scene.materials)
    std::visit(
        [&](auto& kind) {
          if constexpr (requires { kind.reflectance; })
            if (kind.reflectance.coloured) kind.reflectance = flat(kind.reflectance.channels);
        },
        material.kind);
  return scene;
}

struct Found {
  int vertices, technique, bin;
  double value;
  Colour light;
};

std::vector<Found> found_in(const description::Scene& description, Roulette roulette) {
  const auto scene = build_scene<W>(description);
  const Transport<W> space(*scene, roulette);
  PathSampler<Transport<W>> sampler(space, all_techniques, Heuristic::balance);
  std::vector<Found> all;
  Rng rng(1, Purpose::estimate, 0);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    rng.start(i);
    sampler.sample(rng, [&](const Path<W>& x, int s, double value) {
      Found found{x.size(), s, space.bin(x), value, {}};
      for (std::size_t k = 0; k < 3; ++k) found.light[k] = value * colour(x)[static_cast<int>(k)];
      all.push_back(found);
    });
  }
  return all;
}

// Path by path.
TEST(Texturing, WithOneTexelIsAColour) {
  for (const Roulette roulette : {Roulette::off, Roulette::by_albedo}) {
    const auto plain = found_in(coloured_box(), roulette),
               textured = found_in(flatly_textured_box(), roulette);
    ASSERT_GT(plain.size(), 1000U);
    ASSERT_EQ(plain.size(), textured.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_EQ(plain[i].bin, textured[i].bin);
      ASSERT_EQ(plain[i].technique, textured[i].technique);
      EXPECT_NEAR(textured[i].value, plain[i].value, 1e-13 * plain[i].value);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(textured[i].light[k], plain[i].light[k], 1e-13 * plain[i].light[k]);
    }
  }
}

// Left half of the picture red, right half blue, with a black row.
Shared stripes() {
  return std::make_shared<const Texture>(
      Texture::Picture{2, 2, 3, {2, 1, 1, 1, 1, 2, 0, 0, 0, 0, 0, 0}, {}, {0, 0.1, 0.9}});
}

// A floor that listens, textured, below a lamp, beside a textured mesh and metal.
description::Scene striped_room() {
  description::Scene scene;
  scene.dimension = 3;
  scene.max_vertices = 5;
  scene.materials = {{"stripes", description::Diffuse{said_by(stripes())}},
                     {"metal", description::RoughConductor{0.5, said_by(stripes())}},
                     {"white", description::Diffuse{{{0.8, 0.8, 0.8}, false}}}};
  const auto sheet = [&](description::Coordinates o, description::Coordinates a,
                         description::Coordinates b, std::size_t material) -> auto& {
    auto& shape = scene.shapes.emplace_back();
    shape.kind = description::Parallelogram{o, {a, b}};
    shape.material = material;
    return shape;
  };
  sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0).sensor = description::Sensor{{3, 3}};
  sheet({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0);
  sheet({1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1);
  sheet({0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 2);
  sheet({0.3, 0.3, 0.95}, {0, 0.4, 0}, {0.4, 0, 0}, 2).light =
      description::Light{{{3, 3, 3}, false}};
  Triangles mesh;
  mesh.points = {{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
  mesh.corners = {{0, 1, 2}, {0, 2, 3}};
  mesh.coordinates = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
  description::Mesh wall;
  wall.triangles = std::make_shared<const Triangles>(mesh);
  auto& shape = scene.shapes.emplace_back();
  shape.kind = std::move(wall);
  shape.material = 0;
  return scene;
}

TEST(Texturing, IsTheSameForEveryEstimator) {
  const auto scene = build_scene<W>(striped_room());
  std::vector<SampledFilm> films;
  for (const auto name : {"pt", "lt", "bdpt", "pt-naive"})
    films.push_back(sample_film(*scene, find_estimator(name), 60'000, films.size() + 1));
  for (std::size_t a = 0; a < films.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_TRUE(passes(agree(films[a], films[b])));
  // Control: a room of the mean colours.
  description::Scene mean = striped_room();
  for (auto& material : mean.materials)
    std::visit(
        [](auto& kind) {
          if constexpr (requires { kind.reflectance; }) kind.reflectance.texture = nullptr;
        },
        material.kind);
  EXPECT_TRUE(rejects(
      agree(films[2], sample_film(*build_scene<W>(mean), find_estimator("bdpt"), 60'000, 9))));
}

// [core/texturing.h]: the value is the texel's luminance / π, whatever the neighbours.
TEST(Texturing, ScalesValueColourAndSurvivalAlone) {
  const auto scene = build_scene<W>(striped_room());
  const auto plain = [] {
    description::Scene room = striped_room();
    room.materials[0].kind = description::Diffuse{{{1, 1, 1}, false}};
    return build_scene<W>(room);
  }();
  const auto at = [](const Scene<W>& room, Roulette roulette) {
    Path<W> x(3);
    x.resize(3);
    x[0].place = {{0.5, 0.5, 0.95}, {0, 0, -1}, {0, 0, -1}, 4, 0};
    x[1].place = {{0.25, 0.75, 0}, {0, 0, 1}, glm::normalize(Point(-1, 0, 1)), 0, 0};
    x[2].place = {{0, 0.75, 0.25}, {1, 0, 0}, {}, 1, 0};
    x[0].geometry = x[1].geometry = 1;
    x[1].event = Event::scattering;
    const Transport<W> space(room, roulette);
    space.evaluate(x, 1);
    if (roulette == Roulette::by_albedo) {
      EXPECT_DOUBLE_EQ(space.survival(x[1]), x[1].value * x[1].tint.largest() * std::numbers::pi);
    }
    return x;
  };
  const Path<W> textured = at(*scene, Roulette::off), white = at(*plain, Roulette::off);
  const Colour texel{0.9, 0.1, 0.1};
  EXPECT_DOUBLE_EQ(textured[1].value, luminance(texel) / std::numbers::pi);
  for (int k = 0; k < 3; ++k)
    EXPECT_DOUBLE_EQ(textured[1].tint[k], texel[static_cast<std::size_t>(k)] / luminance(texel));
  EXPECT_EQ(textured[2].from_light, white[2].from_light);
  EXPECT_EQ(textured[0].from_sensor, white[0].from_sensor);
  EXPECT_DOUBLE_EQ(at(*scene, Roulette::by_albedo)[2].from_light,
                   white[2].from_light * texel[0]);
}

}  // namespace
}  // namespace wander::test::texture_test
