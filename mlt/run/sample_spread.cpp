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

// Σ_j a_j of products of two that differ, of one sample, whose paths come bin by bin.
double products(std::span<const Carried> paths, const BinWorth& worth, Partition side) {
  double sum = 0, before = 0;  // of the paths on this bin so far
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (i == 0 || paths[i].bin != paths[i - 1].bin) before = 0;
    const double light = paths[i].light * side.of_samples(paths[i].ratio);
    sum += 2 * worth(paths[i].bin) * light * before;
    before += light;
  }
  return sum;
}

// Of one sample, to each border; puts its paths in the order of their bins.
void add(std::vector<Carried>& paths, const BinWorth& worth, std::span<const double> borders,
         std::vector<Sums>& sums) {
  for (std::size_t k = 0; k < borders.size(); ++k)
    for (const Carried& path : paths) {
      const double light = path.light * Partition{borders[k]}.of_samples(path.ratio);
      sums[k].alone += worth(path.bin) * light * light;
    }
  std::ranges::stable_sort(paths, {}, &Carried::bin);
  for (std::size_t k = 0; k < borders.size(); ++k)
    sums[k].pairs += products(paths, worth, {borders[k]});
}

}  // namespace

std::vector<double> paths_together(std::span<const TrialFindings> groups, const BinWorth& worth,
                                   std::span<const double> borders) {
  std::vector<Sums> sums(borders.size());
  std::vector<Carried> paths;  // of one sample
  for (const TrialFindings& group : groups) {
    const std::vector<TrialLog::Found>& found = group.log->found;
    for (std::size_t i = 0; i < found.size(); ++i) {
      paths.push_back({found[i].bin, found[i].light, found[i].ratio});
      if (i + 1 < found.size() && found[i + 1].sample == found[i].sample) continue;
      add(paths, worth, borders, sums);
      paths.clear();
    }
  }
  std::vector<double> together;
  for (const Sums& of : sums) together.push_back(of.alone > 0 ? 1 + of.pairs / of.alone : 1);
  return together;
}

}  // namespace wander
