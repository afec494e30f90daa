// Powers of two and quarter turns change no decision and no bit: films of a scene multiplied, of
// brighter lights, and of a scene turned left.
#include <gtest/gtest.h>

#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"

namespace wander::test {
namespace {

template <class F>
void for_each_point(description::Scene& scene, F f) {
  for (auto& shape : scene.shapes) {
    if (auto* s = std::get_if<description::Segment>(&shape.kind)) f(s->from), f(s->to);
    if (auto* s = std::get_if<description::Polyline>(&shape.kind))
      for (auto& p : s->points) f(p);
    if (auto* s = std::get_if<description::Circle>(&shape.kind)) f(s->center);
    if (auto* s = std::get_if<description::Arc>(&shape.kind)) f(s->center);
  }
}

description::Scene multiplied(description::Scene scene, double factor) {
  for_each_point(scene, [&](description::Coordinates& p) {
    for (double& c : p) c *= factor;
  });
  for (auto& shape : scene.shapes) {
    if (auto* s = std::get_if<description::Circle>(&shape.kind)) s->radius *= factor;
    if (auto* s = std::get_if<description::Arc>(&shape.kind)) s->radius *= factor;
  }
  return scene;
}

description::Scene turned_left(description::Scene scene) {
  for_each_point(scene, [](description::Coordinates& p) { p = {-p[1], p[0], 0}; });
  return scene;
}

description::Scene brighter(description::Scene scene, double factor) {
  for (auto& shape : scene.shapes)
    if (shape.light)
      for (double& channel : shape.light->radiance.channels) channel *= factor;
  return scene;
}

// Every bit of a film, of each length and in total, after multiplying by `factor`.
std::vector<double> bits(const description::Scene& scene, std::string_view method,
                         double factor = 1) {
  const auto film = sample_film(*build_flatland(scene), find_estimator(method), 5000, 1);
  std::vector<double> values;
  const auto append = [&](const BinValues& bins) {
    for (const BinValue& bin : bins)
      values.insert(values.end(), {factor * bin.value, factor * bin.error});
  };
  append(film.total);
  for (const auto& [n, bins] : film.by_vertices) append(bins);
  return values;
}

TEST(Films, DoNotChangeByABitWhenASceneIsMultipliedByAPowerOfTwo) {
  const auto scene = full_room(8).description();
  for (const auto method : {"pt", "lt", "bdpt"})
    for (const int power : {-100, -3, 100})
      EXPECT_EQ(bits(multiplied(scene, std::ldexp(1.0, power)), method), bits(scene, method))
          << method << ", 2^" << power;
  EXPECT_NE(bits(multiplied(scene, 3), "bdpt"), bits(scene, "bdpt"));  // a factor of 3 rounds
}

TEST(Films, GrowWithTheLightWithoutLosingABit) {
  const auto scene = full_room(8).description();
  for (const auto method : {"pt", "lt", "bdpt"})
    for (const int power : {-100, 100}) {
      const double factor = std::ldexp(1.0, power);
      EXPECT_EQ(bits(brighter(scene, factor), method), bits(scene, method, factor)) << method;
    }
}

TEST(Films, DoNotChangeByABitWhenASceneOfSegmentsIsTurnedByAQuarter) {
  const auto scene = open_room(6).description();
  for (const auto method : {"pt", "lt", "bdpt"})
    EXPECT_EQ(bits(turned_left(scene), method), bits(scene, method)) << method;
}

}  // namespace
}  // namespace wander::test
