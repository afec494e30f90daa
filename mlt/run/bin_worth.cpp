#include "mlt/run/bin_worth.h"

namespace wander {

BinWorth::BinWorth(std::span<const int> resolution, std::span<const TrialFindings> groups) {
  if (resolution.size() < 2) return;
  TestImage image(resolution);
  std::uint64_t samples = 0;
  for (const TrialFindings& group : groups) {
    samples += group.log->samples;
    for (const TrialLog::Found& path : group.log->found) image.add(path.bin, path.light);
  }
  worth_ = image.importance(samples);
}

}  // namespace wander
