#include "mlt/run/sample_spread.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wander {

namespace {

struct Carried {
  int bin;
  double light;
};

// Σ_j a_j of products of two that differ, of one sample; puts them in the order of their bins.
double products(std::vector<Carried>& paths, const BinWorth& worth) {
  std::ranges::stable_sort(paths, {}, &Carried::bin);
  double sum = 0, before = 0;  // of the paths on this bin so far
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i == 0 || paths[i].bin != paths[i - 1].bin) before = 0;
    sum += 2 * worth(paths[i].bin) * paths[i].light * before;
    before += paths[i].light;
  }
  return sum;
}

}  // namespace

double paths_together(std::span<const TrialFindings> groups, const BinWorth& worth,
                      Partition side) {
  double alone = 0, pairs = 0;
  std::vector<Carried> paths;  // of one sample
  for (const TrialFindings& group : groups) {
    const std::vector<TrialLog::Found>& found = group.log->found;
    for (std::size_t i = 0; i < found.size(); ++i) {
      paths.push_back({found[i].bin, found[i].light * side.of_samples(found[i].ratio)});
      alone += worth(paths.back().bin) * paths.back().light * paths.back().light;
      if (i + 1 < found.size() && found[i + 1].sample == found[i].sample) continue;
      pairs += products(paths, worth);
      paths.clear();
    }
  }
  return alone > 0 ? 1 + pairs / alone : 1;
}

}  // namespace wander
