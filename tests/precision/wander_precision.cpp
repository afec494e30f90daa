// The same paths of the plane and of space in float and in double, held against long double, while one
// property of the scene goes to its extreme (sweep.h).  Prints a line for each setting, precision and
// quantity, parted by tabs:
//   dimension, sweep, setting, precision, quantity, median, largest, paths
// where median and largest are those of the differences of path_precision.h.
#include <algorithm>
#include <cstdio>

#include "tests/precision/sweep.h"
#include "tests/support/extended_world.h"
#include "tests/support/path_precision.h"

namespace wander::test {
namespace {

struct Setting {
  int dimension;
  const char* sweep;
  double value;
};

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

void print(const Setting& at, const char* precision, const PathDifferences& d) {
  const auto line = [&](const char* quantity, const std::vector<double>& differences) {
    std::printf("%d\t%s\t%g\t%s\t%s\t%.3g\t%.3g\t%zu\n", at.dimension, at.sweep, at.value,
                precision, quantity, median(differences), largest(differences), d.paths());
  };
  line("contribution", d.contribution);
  line("density", d.intensity);
  line("weights", d.weights);
  line("acceptance", d.ratio);
}

// Some thousand paths of each setting.
template <World Single, World Double, World Extended>
void measure(const Sweep& sweep, double setting) {
  constexpr std::size_t enough = 4000;
  const description::Scene scene = sweep.make(setting);
  const int fewest = sweep.paths == PathsOf::greatest_length ? scene.max_vertices : 2;
  PathComparison<Single, Extended> in_float(scene);
  PathComparison<Double, Extended> in_double(scene);
  for (int samples = 4; samples <= 4096 && in_float.differences().paths() < enough; samples *= 4) {
    in_float = PathComparison<Single, Extended>(scene);
    in_double = PathComparison<Double, Extended>(scene);
    for_paths<Double>(scene, samples, fewest, [&](const Path<Double>& x) {
      in_float.add(x);
      in_double.add(x);
    });
  }
  const Setting at{Double::dimension, sweep.name, setting};
  print(at, "float", in_float.differences());
  print(at, "double", in_double.differences());
}

}  // namespace
}  // namespace wander::test

int main() {
  using namespace wander;
  using namespace wander::test;
  for (const Sweep& sweep : plane_sweeps())
    for (const double setting : sweep.settings)
      measure<FlatlandSingle, Flatland, FlatlandExtended>(sweep, setting);
  for (const Sweep& sweep : space_sweeps())
    for (const double setting : sweep.settings)
      measure<SpacelandSingle, Spaceland, SpacelandExtended>(sweep, setting);
}
