#include "mlt/run/sample_spread.h"

#include <algorithm>
#include <cstddef>

#include "mlt/run/partition.h"

namespace wander {

namespace {

struct Carried {
  int bin;
  double light, ratio;
};

struct Sums {
  double alone = 0, pairs = 0;
};

// Of one sample, whose paths come bin by bin, Σ_j a_j of the squares of paths, and of products of two that differ.
void add(std::span<const Carried> paths, const BinWorth& worth, Partition side, Sums& sums) {
  double before = 0;  // of the paths on this bin so far
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i == 0 || paths[i].bin != paths[i - 1].bin) before = 0;
    const double light = paths[i].light * side.of_samples(paths[i].ratio);
    const double weighed = worth(paths[i].bin) * light;
    sums.alone += weighed * light;
    sums.pairs += 2 * weighed * before;
    before += light;
  }
}

}  // namespace

std::vector<double> paths_together(std::span<const TrialFindings> groups, const BinWorth& worth,
                                   std::span<const Partition> borders,
                                   const std::function<bool()>& is_over) {
  std::vector<Sums> sums(borders.size());
  std::vector<Carried> paths;  // of one sample
  for (const TrialFindings& group : groups) {
    const std::vector<TrialLog::Found>& found = group.log->found;
    for (std::size_t i = 0; i < found.size(); ++i) {
      paths.push_back({found[i].bin, found[i].light, found[i].ratio});
      if (i + 1 < found.size() && found[i + 1].sample == found[i].sample) continue;
      if (is_over()) return std::vector<double>(borders.size(), 1);
      std::ranges::stable_sort(paths, {}, &Carried::bin);
      for (std::size_t k = 0; k < borders.size(); ++k) add(paths, worth, borders[k], sums[k]);
      paths.clear();
    }
  }
  std::vector<double> together;
  for (const Sums& of : sums) together.push_back(of.alone > 0 ? 1 + of.pairs / of.alone : 1);
  return together;
}

}  // namespace wander
