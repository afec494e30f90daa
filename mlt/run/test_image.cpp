#include "mlt/run/test_image.h"

#include <numeric>

namespace wander {

TestImage::TestImage(std::span<const int> resolution) : raster_(resolution, most_blocks) {}

std::vector<double> TestImage::light_of_blocks(std::uint64_t samples) const {
  double light = 0;
  for (const Found& path : found_) light += path.light;
  const double most = brightest * light / static_cast<double>(samples);
  std::vector<double> blocks(raster_.cells());
  for (const Found& path : found_) blocks[path.cell] += path.light * most / (path.light + most);
  return blocks;
}

std::optional<ImportanceMap> TestImage::importance(std::uint64_t samples) const {
  const std::vector<double> blocks = light_of_blocks(samples);
  const double all = std::accumulate(blocks.begin(), blocks.end(), 0.0);
  if (!(all > 0)) return std::nullopt;
  const double mean = all / static_cast<double>(blocks.size());
  std::vector<double> factors;
  double of_light = 0;  // E_π[v]
  for (const double light : blocks) {
    factors.push_back(1 / (light + darkest * mean));
    of_light += light / all * factors.back();
  }
  for (double& factor : factors) factor /= of_light;
  return ImportanceMap(raster_, std::move(factors));
}

}  // namespace wander
