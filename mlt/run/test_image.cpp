#include "mlt/run/test_image.h"

#include <algorithm>
#include <numeric>

namespace wander {

namespace {

// Of each cell of a raster over a film, the last of which in a row or a column may have fewer.
std::vector<double> pixels_of_cells(std::span<const int> film, const std::vector<int>& raster) {
  std::vector<double> pixels{1};
  for (std::size_t axis = 0; axis < film.size(); ++axis) {
    int edge = 1;
    while ((film[axis] - 1) / edge >= raster[axis]) edge *= 2;
    std::vector<double> rows;
    for (const double of_row : pixels)
      for (int k = 0; k < raster[axis]; ++k)
        rows.push_back(of_row * std::min(edge, film[axis] - k * edge));
    pixels = std::move(rows);
  }
  return pixels;
}

}  // namespace

TestImage::TestImage(std::span<const int> resolution)
    : raster_(resolution, most_cells), pixels_(pixels_of_cells(resolution, raster_.shape())) {}

TestImage::Light TestImage::found(std::uint64_t samples) const {
  double all = 0;
  for (const Found& path : found_) all += path.light;
  const double of_sample = all / static_cast<double>(samples);
  Light light{std::vector<double>(raster_.cells())};
  double sum = 0, squares = 0;
  for (const Found& path : found_) {
    const double ratio = path.light / of_sample, of_path = ratio * brightest / (ratio + brightest);
    light.of_cells[path.cell] += of_path;
    sum += of_path;
    squares += of_path * of_path;
  }
  light.of_path = sum > 0 ? squares / sum : 0;
  return light;
}

std::vector<double> TestImage::believed(const Light& found) const {
  const std::size_t cells = raster_.cells();
  const double all = std::accumulate(found.of_cells.begin(), found.of_cells.end(), 0.0),
               pixels = std::accumulate(pixels_.begin(), pixels_.end(), 0.0),
               prior = paths_of_prior * found.of_path;
  std::vector<double> light(cells, all / pixels);
  // Blocks of cells, from the largest.
  std::vector<Raster> levels{Raster(raster_.shape(), cells)};
  while (levels.back().cells() > 1) levels.emplace_back(raster_.shape(), levels.back().cells() - 1);
  for (auto blocks = levels.rbegin(); blocks != levels.rend(); ++blocks) {
    std::vector<double> sums(blocks->cells()), extents(blocks->cells());
    for (std::size_t k = 0; k < cells; ++k) {
      const std::size_t block = blocks->cell(static_cast<int>(k));
      sums[block] += found.of_cells[k];
      extents[block] += pixels_[k];
    }
    for (std::size_t k = 0; k < cells; ++k) {
      const std::size_t block = blocks->cell(static_cast<int>(k));
      const double of_parent = light[k] * extents[block];
      light[k] = (sums[block] + prior) / (1 + prior / of_parent) / extents[block];
    }
  }
  return light;
}

std::optional<ImportanceMap> TestImage::importance(std::uint64_t samples) const {
  const Light light = found(samples);
  const double all = std::accumulate(light.of_cells.begin(), light.of_cells.end(), 0.0);
  if (!(all > 0)) return std::nullopt;
  const std::vector<double> image = believed(light);
  double mean = 0;
  for (std::size_t k = 0; k < image.size(); ++k) mean += pixels_[k] * image[k];
  mean /= std::accumulate(pixels_.begin(), pixels_.end(), 0.0);
  std::vector<double> factors;
  double of_light = 0;  // E_π[v]
  for (std::size_t k = 0; k < image.size(); ++k) {
    factors.push_back(1 / (image[k] + darkest * mean));
    of_light += light.of_cells[k] / all * factors.back();
  }
  for (double& factor : factors) factor /= of_light;
  return ImportanceMap(raster_, std::move(factors));
}

}  // namespace wander
