// The sampler of MMLT [Hachisuka, Kaplanyan and Dachsbacher 2014]: u makes one path of n vertices.
// Its first coordinate chooses one of the n_k techniques of that length, s = floor(u_0 n_k), and
//   C*_n(u) = n_k w_s f / p_s  =  n_k f / Σ_j p_j      (balance heuristic),
// whose mean is b_n, the light of paths of n vertices.
#pragma once

#include "core/path_sides.h"
#include "mlt/chain.h"
#include "mlt/primary/primary_chain.h"
#include "mlt/primary/single_technique.h"

namespace wander {

template <class W>
struct MultiplexedPath {
  explicit MultiplexedPath(int vertices) : path(vertices) {}

  Path<W> path;
  int technique = 0;
  int bin = 0;
  double total = 0;  // C*_n
  Reason flaw = Reason::zero_contribution;

  // Its only splat.
  template <class F>
  void for_each_share(F&& f) const {
    if (total > 0) f(path.size(), bin, 1.0, colour(path));
  }
};

template <class Space>
class MultiplexedSampler {
 public:
  using W = typename Space::Universe;
  using Sample = MultiplexedPath<W>;

  MultiplexedSampler(const Space& space, int vertices)
      : space_(space), vertices_(vertices), layout_(vertices) {}

  int vertices() const { return vertices_; }
  int techniques() const { return technique_count(space_, vertices_); }
  const PrimaryLayout<W>& layout() const { return layout_; }
  std::size_t coordinates() const { return layout_.of_walks(); }
  Sample make_sample() const { return Sample(vertices_); }

  template <class Random>
  void draw(Random& random, Sample& y) const {
    y.technique = random.choose(techniques());
    y.total = 0;
    y.flaw = sample_technique(space_, y.path, vertices_, y.technique, random);
    if (y.flaw != Reason::none) return;
    const PathSides<W> sides =
        sides_of(space_, y.path, y.technique, {all_techniques, Heuristic::balance});
    y.total = techniques() * weighted_contribution(y.path, y.technique, sides);
    if (y.total > 0) {
      weigh(space_, y.path);
      y.bin = space_.bin(y.path);
    } else {
      y.flaw = Reason::zero_contribution;
    }
  }

  // The coordinates of a path that a bidirectional sample found by technique s, among the numbers
  // of that sample.  `place` in [0,1) is where in its cell the number that chooses the technique
  // lies.
  PrimaryNumbers coordinates_of(const PrimaryNumbers& sample, const PrimaryLayout<W>& of_sample,
                                int s, double place) const {
    PrimaryNumbers numbers(coordinates());
    const int n = vertices_, t = n - s;
    const double first = (s + place) / techniques();
    numbers.set(0, static_cast<int>(first * techniques()) == s ? first : (s + 0.5) / techniques());
    const auto copy = [&](RandomPlace from, RandomPlace to) {
      const std::size_t source = of_sample.first(from), target = layout_.first(to);
      for (std::size_t j = 0; j < PrimaryLayout<W>::stride; ++j)
        if (sample.holds(source + j)) numbers.set(target + j, sample[source + j]);
    };
    for (int i = 0; i < s; ++i) copy({Subpath::light, i}, {Subpath::light, i});
    for (int i = 0; i < t; ++i) copy({Subpath::sensor, i}, {Subpath::sensor, i});
    // The ends that the sample drew anew for this connection.
    if (s == 1 && t > 1) copy({Subpath::light_end, t}, {Subpath::light, 0});
    if (t == 1 && s > 1) copy({Subpath::sensor_end, s}, {Subpath::sensor, 0});
    return numbers;
  }

 private:
  const Space& space_;
  int vertices_;
  PrimaryLayout<W> layout_;
};

// The step of such a chain as one in path space, for those who watch paths: with `density` K of the
// numbers, the same both ways, and 1 / n_k of the technique in either,
//   T(x→y) = K p_s(y) / w_s(y) = K Σ_j p_j(y),   a = min(1, f(y) T(y→x) / (f(x) T(x→y))).
template <class W>
Step<W> path_step(const PrimaryStep<MultiplexedPath<W>>& step) {
  const Path<W>&x = step.current.path, &y = step.proposed.path;
  Proposed outcome = Failure{step.reason};
  if (step.proposed.total > 0)
    outcome = Proposal{step.density * y.intensity, step.density * x.intensity};
  return {x, y, step.mutation(), outcome, step.acceptance, step.reason};
}

}  // namespace wander
