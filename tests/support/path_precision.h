// The same paths measured in two precisions: how far contributions, densities, weights and ratios of
// acceptance are apart.
//
//   f, Σ_s p_s, f/Σ p (y) : f/Σ p (x)   relative differences
//   w_s                                 absolute differences, the largest of a path
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/path_sampler.h"
#include "core/transport.h"
#include "scenes/format/build_scene.h"

namespace wander::test {

// A path of double precision at the same points in another world.
template <World W, World Base>
void transfer(const Transport<W>& space, const Path<Base>& x, Path<W>& y) {
  y.resize(x.size());
  for (int i = 0; i < x.size(); ++i) {
    y[i].place.position = typename W::Point(x[i].place.position);
    y[i].place.normal = typename W::Direction(x[i].place.normal);
    y[i].place.shape = x[i].place.shape;
    y[i].place.primitive = x[i].place.primitive;
    y[i].event = x[i].event;
  }
  for (int i = 0; i + 1 < x.size(); ++i) space.connect(y, i);
  for (int i = 0; i < x.size(); ++i) space.evaluate(y, i);
  weigh(space, y);
}

inline double relative_difference(Scaled a, Scaled b) { return std::abs((a / b).value() - 1); }

// NaN where one of them is.
inline double largest(const std::vector<double>& differences) {
  double most = 0;
  for (const double found : differences)
    if (!(found <= most)) most = found;
  return most;
}

// One number for each path; ratios for each path but the first.
struct PathDifferences {
  std::vector<double> contribution, intensity, weights, ratio;
  int longest = 0;

  std::size_t paths() const { return contribution.size(); }
  double largest_of_all() const {
    return largest({largest(contribution), largest(intensity), largest(weights), largest(ratio)});
  }
};

// Keeps the paths of a scene in two worlds, and how far they are apart.
template <World A, World B>
class PathComparison {
 public:
  explicit PathComparison(const description::Scene& scene)
      : a_(build_scene<A>(scene)),
        b_(build_scene<B>(scene)),
        in_a_(scene.max_vertices),
        in_b_(scene.max_vertices) {}

  template <World Base>
  void add(const Path<Base>& x) {
    transfer(Transport<A>(*a_, Roulette::off), x, in_a_);
    transfer(Transport<B>(*b_, Roulette::off), x, in_b_);
    const Scaled ratio_a = in_a_.contribution / in_a_.intensity;
    const Scaled ratio_b = in_b_.contribution / in_b_.intensity;
    if (d_.paths() > 0)
      d_.ratio.push_back(relative_difference(ratio_a / last_a_, ratio_b / last_b_));
    d_.contribution.push_back(relative_difference(in_a_.contribution, in_b_.contribution));
    d_.intensity.push_back(relative_difference(in_a_.intensity, in_b_.intensity));
    std::vector<double> weights;
    for (std::size_t s = 0; s < in_a_.weights().size(); ++s)
      weights.push_back(std::abs(in_a_.weights()[s] - in_b_.weights()[s]));
    d_.weights.push_back(largest(weights));
    last_a_ = ratio_a;
    last_b_ = ratio_b;
    d_.longest = std::max(d_.longest, x.size());
  }
  const PathDifferences& differences() const { return d_; }

 private:
  std::unique_ptr<const Scene<A>> a_;
  std::unique_ptr<const Scene<B>> b_;
  Path<A> in_a_;
  Path<B> in_b_;
  Scaled last_a_, last_b_;
  PathDifferences d_;
};

// Calls f with the paths of bidirectional samples, of so many vertices or more.
template <World W, class F>
void for_paths(const description::Scene& scene, int samples, int fewest_vertices, F&& f) {
  const auto built = build_scene<W>(scene);
  PathSampler<Transport<W>> sampler(Transport<W>(*built, Roulette::off), all_techniques,
                                    Heuristic::balance);
  Rng random(1, Purpose::test, 70);
  for (int i = 0; i < samples; ++i) {
    random.start(static_cast<std::uint64_t>(i));
    sampler.sample(random, [&](const Path<W>& x, int, double) {
      if (x.size() >= fewest_vertices) f(x);
    });
  }
}

}  // namespace wander::test
