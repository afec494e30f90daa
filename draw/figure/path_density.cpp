#include "draw/figure/path_density.h"

#include <fmt/format.h>

namespace wander::figure {
namespace {

constexpr int columns = 200;
constexpr double most_height = 230;

}  // namespace

std::vector<double> path_density(const Steps& steps, const PlaneGrid& grid) {
  std::vector<double> length(grid.size());
  double count = 0;
  steps.each([&](const Step& step) {
    const std::vector<Vector> path = steps.path(steps.trajectory().state, step.index);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      grid.cross(path[i], path[i + 1],
                 [&](std::size_t cell, double within) { length[cell] += within; });
    count += 1;
  });
  if (count > 0)
    for (double& sum : length) sum /= count * grid.cell_area();
  return length;
}

Block density_picture(const Steps& steps, const description::Scene& scene, double width) {
  const PlaneGrid grid = grid_over(scene, columns);
  Block block = picture_block({scene,
                               grid,
                               path_density(steps, grid),
                               {"mean length of path per area", "1/m"},
                               ink_colours(),
                               Ground::light},
                              width, most_height);
  bool is_empty = true;
  steps.each([&](const Step&) { is_empty = false; });
  block.heading = fmt::format("Density of visited paths, {}{}", in_words(steps),
                              is_empty ? ": no step was chosen" : "");
  return block;
}

}  // namespace wander::figure
