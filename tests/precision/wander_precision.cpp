// The same paths of the plane in float and in double, held against long double, while one property of
// the scene goes to its extreme.  Prints a line for each setting, precision and quantity, parted by tabs:
//   sweep, setting, precision, quantity, median, largest, paths
// where median and largest are those of the differences of path_precision.h; the setting 0.1 of
// `angle` is a room whose cosines are of that size.
#include <cstdio>

#include "tests/support/core_scenes.h"
#include "tests/support/extended_world.h"
#include "tests/support/path_precision.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

// `setting` vertices in a room of diffuse walls.
description::Scene of_length(double setting) {
  description::Scene scene = diffuse_room();
  scene.max_vertices = static_cast<int>(setting);
  return scene;
}
// Light and sensor face each other at so small a part of their length: cosines are as small.
description::Scene of_angle(double setting) {
  SceneMaker maker(4);
  const std::size_t wall = maker.diffuse(0.7);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4});
  maker.segment({1, 1.1 * setting}, {0, setting}, {wall, 1});
  return maker.description();
}
// Metal and glass of this roughness.
description::Scene of_roughness(double setting) {
  SceneMaker maker(5);
  const std::size_t wall = maker.diffuse(0.6);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4}).segment({1, 0}, {1.1, 0.9}, {wall, 1});
  maker.segment({1.1, 0.9}, {0, 1}, {maker.rough_metal(setting, 0.9)});
  maker.segment({0, 1}, {0, 0}, {wall});
  maker.circle({0.5, 0.4}, 0.15, {maker.rough_glass(setting, 1.5)});
  return maker.description();
}
// Light and sensor so many of their lengths apart, with a wall beside the sensor.
description::Scene of_distance(double setting) {
  SceneMaker maker(4);
  const std::size_t wall = maker.diffuse(0.7);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4}).segment({1.2, 0.1}, {1.3, 0.9}, {wall});
  maker.segment({1.1, setting}, {0.1, setting * 1.01}, {wall, 1});
  return maker.description();
}
// A room so many of its diameters from the origin.
description::Scene of_offset(double setting) {
  SceneMaker maker(6);
  const std::size_t plaster = maker.diffuse(0.7);
  const auto at = [&](double x, double y) { return PlanePoint{setting + x, setting + y}; };
  maker.segment(at(0, 0), at(1, 0.05), {plaster, 0, 4})
      .segment(at(1, 0.05), at(0.95, 1), {plaster});
  maker.segment(at(0.95, 1), at(0, 0.9), {plaster, 2}).segment(at(0, 0.9), at(0, 0), {plaster});
  maker.circle(at(0.5, 0.4), 0.15, {maker.rough_glass(0.2, 1.5)});
  return maker.description();
}

struct Sweep {
  const char* name;
  description::Scene (*make)(double);
  std::vector<double> settings;
};
const Sweep sweeps[] = {
    {"length", of_length, {2, 4, 8, 16, 32, 64, 128, 256}},
    {"angle", of_angle, {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
    {"roughness", of_roughness, {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
    {"distance", of_distance, {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12}},
    {"offset", of_offset, {1, 1e2, 1e4, 1e6, 1e8, 1e10}},
};

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

void print(const Sweep& sweep, double setting, const char* precision, const PathDifferences& d) {
  const auto line = [&](const char* quantity, const std::vector<double>& differences) {
    std::printf("%s\t%g\t%s\t%s\t%.3g\t%.3g\t%zu\n", sweep.name, setting, precision, quantity,
                median(differences), largest(differences), d.paths());
  };
  line("contribution", d.contribution);
  line("density", d.intensity);
  line("weights", d.weights);
  line("acceptance", d.ratio);
}

// Some thousand paths of each setting; of a sweep of lengths those of that length alone.
void measure(const Sweep& sweep, double setting) {
  constexpr std::size_t enough = 4000;
  const description::Scene scene = sweep.make(setting);
  const int fewest = sweep.make == of_length ? scene.max_vertices : 2;
  PathComparison<FlatlandSingle, FlatlandExtended> in_float(scene);
  PathComparison<Flatland, FlatlandExtended> in_double(scene);
  for (int samples = 4; samples <= 4096 && in_float.differences().paths() < enough; samples *= 4) {
    in_float = PathComparison<FlatlandSingle, FlatlandExtended>(scene);
    in_double = PathComparison<Flatland, FlatlandExtended>(scene);
    for_paths(scene, samples, fewest, [&](const Path<Flatland>& x) {
      in_float.add(x);
      in_double.add(x);
    });
  }
  print(sweep, setting, "float", in_float.differences());
  print(sweep, setting, "double", in_double.differences());
}

}  // namespace
}  // namespace wander::test

int main() {
  using namespace wander::test;
  for (const Sweep& sweep : sweeps)
    for (const double setting : sweep.settings) measure(sweep, setting);
}
