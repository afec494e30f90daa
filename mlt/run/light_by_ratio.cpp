#include "mlt/run/light_by_ratio.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wander {

namespace {

constexpr double seen_tail = 0.05;    // S(t₁)
constexpr double end_of_tail = 1e-4;  // what a run of usual size will not see
constexpr double octave = 1 << RatioHistogram::bits_per_octave;

// A share of the light for each bin of a histogram, from `first` on.
struct Shares {
  int first;
  std::vector<double> of;

  double& at(int i) { return of[static_cast<std::size_t>(i - first)]; }
  int last() const { return first + static_cast<int>(of.size()) - 1; }
};

// S at the lower end of each bin first … last.
template <class Light>
Shares light_above(const RatioHistogram& ratios, int first, int last, Light&& light) {
  Shares above{first, std::vector<double>(static_cast<std::size_t>(last - first) + 1)};
  double sum = 0;
  for (int i = last; i >= first; --i) above.at(i) = sum += light(ratios[i]);
  for (double& share : above.of) share = sum > 0 ? share / sum : 0;
  return above;
}

// Of all chains with steps but, at each bin, the one of which most is above.
Shares states_above(std::span<const RatioHistogram> chains, int first, int last) {
  Shares above{first, std::vector<double>(static_cast<std::size_t>(last - first) + 1)};
  std::vector<double> most(above.of.size());
  int count = 0;
  for (const RatioHistogram& chain : chains) {
    if (!(chain.count() > 0)) continue;
    ++count;
    const Shares one = light_above(chain, first, last, [](const auto& bin) { return bin.count; });
    for (std::size_t k = 0; k < one.of.size(); ++k) {
      above.of[k] += one.of[k];
      most[k] = std::max(most[k], one.of[k]);
    }
  }
  if (count < 2) return above;
  for (std::size_t k = 0; k < above.of.size(); ++k)
    above.of[k] = (above.of[k] - most[k]) / (count - 1);
  return above;
}

// The last bin where S is no less.
int reach(const Shares& above, double share) {
  const auto beyond = std::ranges::partition_point(above.of, [&](double s) { return s >= share; });
  return above.first + static_cast<int>(beyond - above.of.begin()) - 1;
}

// α; infinite where S has a step.
double power_between(Shares& above, double more, double less) {
  const int begin = reach(above, more), end = reach(above, less);
  if (begin == end) return std::numeric_limits<double>::infinity();
  return std::log2(above.at(begin) / above.at(end)) * octave / (end - begin);
}

void add_tail(Shares& above) {
  const double power =
      std::max({power_between(above, 0.3, seen_tail), power_between(above, 0.15, 0.025),
                power_between(above, seen_tail, 0.0125)});
  if (!std::isfinite(power)) return;
  const int end = reach(above, seen_tail);
  const double share = above.at(end);
  const int last = end + static_cast<int>(std::log2(share / end_of_tail) * octave / power);
  if (last > above.last()) above.of.resize(static_cast<std::size_t>(last - above.first) + 1);
  for (int i = end + 1; i <= last; ++i)
    above.at(i) = std::max(above.at(i), share * std::exp2(-power * (i - end) / octave));
}

// l of a bin: the mean of what is in it, or its middle.
double ratio_of(int bin, const RatioHistogram& all) {
  return all[bin].count > 0 ? all[bin].sum / all[bin].count : RatioHistogram::middle(bin);
}

}  // namespace

LightByRatio::LightByRatio(const RatioHistogram& found, std::span<const RatioHistogram> chains) {
  RatioHistogram all = found;
  for (const RatioHistogram& chain : chains) all.add(chain, 1);
  const int first = all.first(), last = all.end() - 1;
  Shares above = light_above(found, first, last, [](const auto& bin) { return bin.sum; });
  const Shares by_states = states_above(chains, first, last);
  for (std::size_t k = 0; k < above.of.size(); ++k)
    above.of[k] = std::max(above.of[k], by_states.of[k]);
  add_tail(above);
  for (int i = above.first; i <= above.last(); ++i) {
    const double light = above.at(i) - (i < above.last() ? above.at(i + 1) : 0);
    if (light > 0) cells_.push_back({ratio_of(i, all), light});
  }
}

}  // namespace wander
