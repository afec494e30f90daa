// Independent weighted paths from which kernels are tested.
//
// A bidirectional sample, whose walks play Russian roulette, holds paths x_k with weights
// W_k = f(x_k) / p(x_k), where p = Σ_s q_{s,t} p_{s,t} is the intensity of all techniques under
// roulette.  Weights above a bound C are clipped,
//   v_k = W_k c(x_k),  c(x) = min(1, C p(x) / f(x)),
// so that no rare path outweighs all others, and one path is chosen in proportion to v_k.  It has
// the weight Σ_k v_k; a sample without paths counts as zero.  So E[v h(x)] = ∫ c f h.  Samples
// lighter than average are dropped by a roulette that gives the average to those it keeps.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/path_sampler.h"

namespace wander {

// How bright samples are is looked up in so many that found light, or tried to.
struct StartsPilot {
  std::uint64_t enough = 1000, most_tried = 1 << 18;
};

template <class Space>
class Starts {
 public:
  using W = typename Space::Universe;

  Starts(const Space& space, std::uint64_t seed, const StartsPilot& size = {})
      : space_(space),
        size_(size),
        sampler_(space.with(Roulette::by_albedo), all_techniques, Heuristic::balance),
        numbers_(seed, Purpose::test, 0),
        choice_(seed, Purpose::test, 1),
        path_(space.max_vertices()) {
    pilot();
  }

  bool found_light() const { return average_ > 0; }
  std::uint64_t tried() const { return tried_; }

  // The weight of sample number i; if it is positive, path() is one of the sample's paths.
  double draw(std::uint64_t i) {
    const double weight = sample(i), kept = roulette(weight);
    if (kept > 0)
      for (int k = 0; k < path_.size(); ++k) space_.evaluate(path_, k);
    return kept;
  }
  // Measured as one of the space, which has no roulette.
  const Path<W>& path() const { return path_; }

  // c(x) of a path that is measured.
  double clip(const Path<W>& x) const {
    const double weight = (x.contribution / x.intensity_under_roulette).value();
    return weight > bound_ ? bound_ / weight : 1;
  }

 private:
  static constexpr double clipped_above = 4;  // times the average of the samples that found light

  void pilot() {
    double sum = 0;
    std::uint64_t lit = 0;
    for (; tried_ < size_.most_tried && lit < size_.enough; ++tried_) {
      const double weight = sample(~tried_);
      sum += weight;
      if (weight > 0) ++lit;
    }
    if (lit == 0) return;
    average_ = sum / static_cast<double>(lit);
    bound_ = clipped_above * average_;
  }
  double roulette(double weight) {
    if (weight >= average_) return weight;
    return choice_.uniform() * average_ < weight ? average_ : 0;
  }
  double sample(std::uint64_t i) {
    numbers_.start(i);
    choice_.start(i);
    double total = 0;
    sampler_.sample(numbers_, [&](const JoinedPath<W>& x, int, double weight) {
      const double clipped = std::min(weight, bound_);
      total += clipped;
      if (choice_.uniform() * total < clipped) path_ = x.whole();
    });
    return total;
  }

  const Space& space_;
  StartsPilot size_;
  PathSampler<Space> sampler_;
  Rng numbers_, choice_;
  Path<W> path_;
  double average_ = 0, bound_ = std::numeric_limits<double>::infinity();
  std::uint64_t tried_ = 0;
};

}  // namespace wander
