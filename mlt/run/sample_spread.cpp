#include "mlt/run/sample_spread.h"

#include <cstddef>

namespace wander {

double paths_together(std::span<const TrialFindings> groups, const BinWorth& worth,
                      Partition side) {
  double alone = 0, pairs = 0;
  for (const TrialFindings& group : groups) {
    const std::vector<TrialLog::Found>& found = group.log->found;
    const auto easy = [&](std::size_t i) {
      return found[i].light * side.of_samples(found[i].ratio);
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double x = worth(found[i].bin) * easy(i);
      alone += x * easy(i);
      for (std::size_t k = i + 1; k < found.size() && found[k].sample == found[i].sample; ++k)
        if (found[k].bin == found[i].bin) pairs += 2 * x * easy(k);
    }
  }
  return alone > 0 ? 1 + pairs / alone : 1;
}

}  // namespace wander
