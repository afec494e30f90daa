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
  int vertices = 0, bin = 0;
  double weight = 0;  // w f / p
  [[no_unique_address]] typename W::Tint colour{};
};

// Memory is reserved once, for a splat of every technique, and where paths may be long for so many that
// under roulette hardly a sample has more.
template <class W>
class SampleSplats {
 public:
  static constexpr std::size_t reserved = 2048;

  explicit SampleSplats(int max_vertices) {
    const auto n = static_cast<std::size_t>(max_vertices) + 1;
    splats.reserve(std::min(n * (n + 1) / 2, reserved));
  }

  void clear() {
    splats.clear();
    total = 0;
    flaw = Reason::zero_contribution;
    brightest_ = {};
    most_ = 0;
  }
  // `features()` of its path are asked for only if it is brighter than all before: they cost as much as the
  // path is long, and a sample of long paths has the square of that in splats.
  template <class OfPath>
  void add(const Splat<W>& splat, OfPath&& features) {
    splats.push_back(splat);
    total += splat.weight;
    if (!(splat.weight > most_)) return;
    flaw = Reason::none;
    brightest_ = features();
    most_ = splat.weight;
  }

  std::vector<Splat<W>> splats;
  double total = 0;  // C*
  Reason flaw = Reason::zero_contribution;

  // f(splat, its share of C*, its colour)
  template <class F>
  void for_each_share(F&& f) const {
    for (const auto& s : splats) f(s.vertices, s.bin, s.weight / total, s.colour);
  }
  // Of the brightest splat, which stands for all where one must; dark if there is none.
  const Features& brightest() const { return brightest_; }

 private:
  Features brightest_{};
  double most_ = 0;  // its weight
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
    sample.clear();
    sampler_.sample(random, [&](const JoinedPath<W>& x, int, double weight) {
      sample.add({x.size(), space_.bin(x.ends()), weight, x.colour()},
                 [&] { return features(space_, x.whole()); });
    });
  }

 private:
  const Space& space_;
  PathSampler<Space> sampler_;
  PrimaryLayout<W> layout_;
};

}  // namespace wander
