#include "mlt/run/bin_worth.h"

#include <numeric>

namespace wander {

namespace {

// The light of each block.  A path counts no more than a few times what a sample does in the mean: one that
// is brighter says more of itself than of the block.
std::vector<double> test_image(const Raster& raster, std::span<const TrialFindings> groups) {
  constexpr double most = 16;
  double light = 0, samples = 0;
  for (const TrialFindings& group : groups) {
    samples += group.log->samples;
    for (const TrialLog::Found& path : group.log->found) light += path.light;
  }
  const double brightest = most * light / samples;
  std::vector<double> image(raster.cells());
  for (const TrialFindings& group : groups)
    for (const TrialLog::Found& path : group.log->found)
      image[raster.cell(path.bin)] += path.light * brightest / (path.light + brightest);
  return image;
}

}  // namespace

BinWorth::BinWorth(std::span<const int> resolution, std::span<const TrialFindings> groups)
    : raster_(resolution, most_blocks) {
  if (resolution.size() < 2) return;
  const std::vector<double> image = test_image(raster_, groups);
  const double all = std::accumulate(image.begin(), image.end(), 0.0);
  if (!(all > 0)) return;
  const double mean = all / static_cast<double>(image.size());
  double of_light = 0;  // E_π[a]
  for (const double light : image) {
    worth_.push_back(1 / (light + darkest * mean));
    of_light += light / all * worth_.back();
  }
  for (double& worth : worth_) worth /= of_light;
}

}  // namespace wander
