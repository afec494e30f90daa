// What runs of chains claim of the brightness of a film where the light of some paths is seldom found: of all of it, in a room
// in two parts whose chains begin in one of them, and in a room in which the chains of most runs never meet what few samples do (unmet_light.h), and of the light of two and three vertices, of which
// samples carry all and chains next to nothing (pooled_lengths).
//
// Intervals of b ± 1.96 standard errors hold it in 0.91 of these runs of the first; where octaves that no chain met are bridged, in 0.76 of 40, which the
// bound below would not see, but 5 of 24 films were called reliable, none of which held it.
// Those of the second hold it in 0.94, those of the two lengths in 0.955 and 0.885; where unmet classes are not told
// b was held in 0.70 of 100 runs, and where lengths are those of chains alone in 0.67 and 0.63 of 30.  Bounds are passed by
// chance once in a million where 0.9 hold, and 0.73 is seen nineteen times in twenty.  Control: errors half as large are caught.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>
#include <vector>

#include "core/exact/diffuse_film.h"
#include "lab/engine.h"
#include "scenes/format/scene_file.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace rare_classes_long_test {
namespace {

constexpr int runs = 200;
constexpr double least_coverage = 0.9, false_alarm = 1e-6;

// A mirror ball and a ball of glass below a tiny lamp, whose light a sensor of one bin on the floor sees in dozens of classes.
constexpr const char* room_of_balls = R"({
  "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 8,
  "materials": { "plaster": { "type": "diffuse", "reflectance": 0.7 },
                 "silver": { "type": "mirror", "reflectance": 0.9 },
                 "glass": { "type": "dielectric", "ior": 1.5 } },
  "shapes": [
    { "type": "parallelogram", "origin": [0,0,0], "edges": [[0,0,2],[2,0,0]], "material": "plaster" },
    { "type": "parallelogram", "origin": [0,2,0], "edges": [[2,0,0],[0,0,2]], "material": "plaster" },
    { "type": "parallelogram", "origin": [0,0,0], "edges": [[2,0,0],[0,2,0]], "material": "plaster" },
    { "type": "parallelogram", "origin": [0,0,2], "edges": [[0,2,0],[2,0,0]], "material": "plaster" },
    { "type": "parallelogram", "origin": [0,0,0], "edges": [[0,2,0],[0,0,2]], "material": "plaster" },
    { "type": "parallelogram", "origin": [2,0,0], "edges": [[0,0,2],[0,2,0]], "material": "plaster" },
    { "type": "parallelogram", "origin": [0.99,1.9,0.99], "edges": [[0.02,0,0],[0,0,0.02]],
      "light": { "radiance": 625 } },
    { "type": "sphere", "center": [1,1,1], "radius": 0.4, "material": "silver" },
    { "type": "sphere", "center": [0.4,0.5,1.2], "radius": 0.25, "material": "glass" },
    { "type": "parallelogram", "origin": [0.8,0.01,0.8], "edges": [[0,0,0.4],[0.4,0,0]],
      "sensor": { "resolution": [1, 1] } } ] })";

// Two rooms with a narrow gap between them, behind which all light is but for that of a faint lamp.
constexpr const char* rooms_with_a_gap = R"({
  "format": "wanderlight-scene/1", "dimension": 2, "max_vertices": 8,
  "materials": { "plaster": { "type": "diffuse", "reflectance": 0.7 } },
  "shapes": [
    { "type": "polyline", "closed": true, "material": "plaster", "points": [[0,0],[4,0],[4,2],[0,2]] },
    { "type": "segment", "from": [2,0], "to": [2,1.195], "material": "plaster" },
    { "type": "segment", "from": [2,1.205], "to": [2,2], "material": "plaster" },
    { "type": "segment", "from": [1,1.76], "to": [0.9,1.8], "light": { "radiance": 100000 } },
    { "type": "segment", "from": [2.4,0.1], "to": [3.4,0.1], "sensor": { "bins": 60 } },
    { "type": "segment", "from": [3.9,1.9], "to": [3.7,1.9], "light": { "radiance": 2 } } ] })";

// The same with a gap so narrow that few samples come through, for most of the light: and one bin, of which no bin around it says that it lacks any.
constexpr const char* rooms_with_a_crack = R"({
  "format": "wanderlight-scene/1", "dimension": 2, "max_vertices": 5,
  "materials": { "plaster": { "type": "diffuse", "reflectance": 0.5 } },
  "shapes": [
    { "type": "polyline", "closed": true, "material": "plaster", "points": [[0,0],[2,0],[2,1],[0,1]] },
    { "type": "segment", "from": [1,0], "to": [1,0.499995] },
    { "type": "segment", "from": [1,0.500005], "to": [1,1] },
    { "type": "segment", "from": [0.7,0.9], "to": [0.5,0.93], "light": { "radiance": 120000 } },
    { "type": "segment", "from": [1.9,0.95], "to": [1.7,0.95], "light": { "radiance": 1 } },
    { "type": "segment", "from": [1.2,0.05], "to": [1.8,0.07], "sensor": { "bins": 1 },
      "material": "plaster" } ] })";

Rendering rendering_of(const description::Scene& scene, std::string_view method,
                       std::uint64_t samples, std::uint64_t seed) {
  Session session;
  session.threads = 2;
  session.seed = seed;
  session.budget = SampleBudget{samples};
  return render({scene, find_method(method)}, session);
}
std::vector<Rendering> many_of(const char* method, const description::Scene& scene,
                               std::uint64_t steps) {
  std::vector<Rendering> all;
  for (std::uint64_t run = 0; run < runs; ++run)
    all.push_back(rendering_of(scene, method, steps, 1000 + run));
  return all;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// How many hold a truth that is known by an error of its own, with errors so many times as large.
std::uint64_t holding(const std::vector<Estimate>& claims, const Estimate& truth, double factor) {
  return static_cast<std::uint64_t>(std::ranges::count_if(claims, [&](const Estimate& claim) {
    const double error = std::hypot(factor * claim.standard_error, truth.standard_error);
    return std::abs(claim.value - truth.value) <= 1.96 * error;
  }));
}
// No more than by chance are too few.
bool enough_hold(std::uint64_t count) {
  return binomial_interval(count, runs, 1 - 2 * false_alarm).high >= least_coverage;
}
void expect_enough(const char* what, const std::vector<Estimate>& claims, const Estimate& truth) {
  ASSERT_EQ(claims.size(), runs) << what;
  const std::uint64_t count = holding(claims, truth, 1);
  std::cout << "  " << what << ": " << count << " of " << runs << " hold " << truth.value << " ± "
            << truth.standard_error << '\n';
  EXPECT_TRUE(enough_hold(count)) << what;
  EXPECT_FALSE(enough_hold(holding(claims, truth, 0.5))) << what;
}

TEST(RareClasses, OfChainsThatBeganElsewhereAreLeftToSamples) {
  const description::Scene scene = parse_scene(rooms_with_a_crack, "rooms").scene;
  const double truth = exact::diffuse_film(scene).value.front();
  std::vector<Estimate> claims;
  int astray = 0;  // that are called reliable
  for (const Rendering& r : many_of("mmlt", scene, 100'000)) {
    claims.push_back(*r.normalization);
    const double off = std::abs(r.film.value.front() - truth);
    astray += r.film.reliable.front() && off > 4 * r.film.standard_error.front() ? 1 : 0;
  }
  expect_enough("b of two parts", claims, {truth, 0});
  EXPECT_LE(astray, 3);
}

TEST(RareClasses, AreInTheIntervalsOfB) {
  const description::Scene scene = parse_scene(room_of_balls, "room").scene;
  const FilmEstimate film = rendering_of(scene, "bdpt", 8'000'000, 4711).film;
  std::vector<Estimate> claims;
  for (const Rendering& r : many_of("mlt", scene, 100'000)) claims.push_back(*r.normalization);
  expect_enough("b", claims, {film.value.front(), film.standard_error.front()});
}

TEST(RareClasses, OfSamplesAloneHaveTheirLight) {
  const description::Scene scene = parse_scene(rooms_with_a_gap, "rooms").scene;
  const FilmEstimate film = rendering_of(scene, "bdpt", 8'000'000, 4711).film;
  std::map<int, std::vector<Estimate>> claims;
  for (const Rendering& r : many_of("mlt", scene, 50'000))
    for (const LengthShare& share : r.normalization->by_length)
      claims[share.vertices].push_back(share);
  expect_enough("two vertices", claims[2], {mean(film.by_length.at(2)), 0});
  expect_enough("three vertices", claims[3], {mean(film.by_length.at(3)), 0});
}

}  // namespace
}  // namespace rare_classes_long_test
}  // namespace wander::test
