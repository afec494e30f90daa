// The sampler of PSSMLT [Kelemen et al. 2002]: u makes one whole bidirectional sample, all its
// techniques by the balance heuristic, and
//   C*(u) = Σ w_{s,t} f / p_{s,t}
// over the paths that it finds, each of which is a splat on the film.  Walks play Russian roulette with
// numbers of u, which p knows of.
#pragma once

#include "core/path_sampler.h"
#include "mlt/primary/primary_numbers.h"
#include "mlt/seeds/seeds.h"
#include "mlt/watch/statistics.h"

namespace wander {

template <class W>
struct Splat {
  Features features{};
  double weight = 0;  // w f / p
  [[no_unique_address]] typename W::Tint colour{};
};

// Memory is reserved once, for a splat of every technique, and where paths may be long for so many that
// under roulette hardly a sample has more.
template <class W>
struct SampleSplats {
  static constexpr std::size_t reserved = 2048;

  explicit SampleSplats(int max_vertices) {
    const auto n = static_cast<std::size_t>(max_vertices) + 1;
    splats.reserve(std::min(n * (n + 1) / 2, reserved));
  }

  std::vector<Splat<W>> splats;
  double total = 0;  // C*
  Reason flaw = Reason::zero_contribution;

  // f(splat, its share of C*, its colour)
  template <class F>
  void for_each_share(F&& f) const {
    for (const auto& s : splats) f(s.features.vertices, s.features.bin, s.weight / total, s.colour);
  }
  // Of the brightest splat, which stands for all where one must; dark if there is none.
  Features brightest() const {
    const auto found = std::ranges::max_element(splats, {}, &Splat<W>::weight);
    return found == splats.end() ? Features{} : found->features;
  }
};

template <class Space>
class SplatSampler {
 public:
  using W = typename Space::Universe;
  using Sample = SampleSplats<W>;

  explicit SplatSampler(const Space& space)
      : space_(space),
        sampler_(space.with(SampleSeeds::roulette), all_techniques, Heuristic::balance),
        layout_(space.max_vertices()) {}

  const PrimaryLayout<W>& layout() const { return layout_; }
  std::size_t coordinates() const { return layout_.of_samples(); }
  Sample make_sample() const { return Sample(space_.max_vertices()); }

  template <class Random>
  void draw(Random& random, Sample& sample) {
    sample.splats.clear();
    sample.total = 0;
    sampler_.sample(random, [&](const Path<W>& x, int, double weight) {
      sample.splats.push_back({features(space_, x), weight, colour(x)});
      sample.total += weight;
    });
    sample.flaw = sample.total > 0 ? Reason::none : Reason::zero_contribution;
  }

 private:
  const Space& space_;
  PathSampler<Space> sampler_;
  PrimaryLayout<W> layout_;
};

}  // namespace wander
