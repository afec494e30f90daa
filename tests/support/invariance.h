// Does a kernel leave f invariant?  Two engines on independent samples of paths, without a
// converged chain, a normalization or a reference [Veach 1997, 11.3.1; the ERPT identity of Cline
// et al. 2005].
//
// Invariance.  With x_0 of density p, w = f/p and x_n after n steps of a kernel K with fK = f,
//   E[ w(x_0) (h(x_n) - h(x_0)) ] = 0        for every bounded h.
// After one step x_1 is y with probability a, so a h(y) + (1-a) h(x_0) stands for h(x_1).
//
// Flux.  With S_ij = Σ w(x_0) a(x_0→y) [x_0 in cell i, y in cell j], detailed balance makes S_ij
// and S_ji equal in expectation.
//
// A start is one path of a bidirectional sample, drawn in proportion to its weight, and has the
// weight of the sample; a sample without paths counts as zero.  Samples lighter than average are
// dropped by a roulette that gives the average weight to those it keeps.
#pragma once

#include <cstdint>
#include <vector>

#include "core/path_sampler.h"
#include "mlt/chain.h"
#include "mlt/mixture.h"
#include "tests/support/path_functions.h"
#include "tests/support/statistics.h"

namespace wander::test {

// A decision about values with few contributions is no decision: a function or a pair of cells
// takes part when (Σ |D|)² / Σ D² is at least this.
inline constexpr double fewest_contributions = 100;
// The detail of a decision, failed, in which nothing takes part.
inline constexpr const char* nothing_moved = "nothing moved";

// Sums over samples of the deviations D of many functions, most of which are zero most of the time.
class Deviations {
 public:
  explicit Deviations(std::size_t functions) : sums_(functions) {}

  void add(std::size_t function, double d) {
    Sums& s = sums_[function];
    s.value += d;
    s.magnitude += std::abs(d);
    s.square += d * d;
  }
  Decision decide(std::uint64_t samples, double false_alarm) const;

 private:
  struct Sums {
    double value = 0, magnitude = 0, square = 0;
  };
  std::vector<Sums> sums_;
};

// Flux between the cells of a partition.
class Flux {
 public:
  explicit Flux(std::size_t cells) : cells_(cells), entries_(cells * cells) {}

  void add(std::size_t from, std::size_t to, double flow) {
    Entry& e = entries_[from * cells_ + to];
    e.flow += flow;
    e.square += flow * flow;
  }
  // z_ij = (S_ij - S_ji) / √(Σ s_ij² + Σ s_ji²).
  Decision decide(double false_alarm) const;

 private:
  struct Entry {
    double flow = 0, square = 0;
  };
  std::size_t cells_;
  std::vector<Entry> entries_;
};

struct InvarianceOptions {
  std::uint64_t samples = 60'000;
  int steps = 20;
  std::uint64_t seed = 1;
  double false_alarm = usual_false_alarm;  // of each of the three decisions
};

struct InvarianceReport {
  Decision one_step, many_steps, flux;
  double acceptance = 0;  // mean a of the first steps

  bool all_pass() const { return one_step.passed && many_steps.passed && flux.passed; }
};

// Draws starts: independent samples of the paths of a space.
template <class Space>
class Starts {
 public:
  using W = typename Space::Universe;

  Starts(const Space& space, std::uint64_t seed)
      : sampler_(space, all_techniques, Heuristic::balance),
        numbers_(seed, Purpose::test, 0),
        choice_(seed, Purpose::test, 1),
        path_(space.max_vertices()) {
    constexpr std::uint64_t pilot = 1000;
    Moments weights;
    for (std::uint64_t i = 0; i < pilot; ++i) weights.add(sample(~i));
    average_ = weights.mean();
  }

  // The weight of sample number i; if it is positive, path() is one of the sample's paths.
  double draw(std::uint64_t i) {
    const double weight = sample(i);
    if (weight >= average_) return weight;
    return choice_.uniform() * average_ < weight ? average_ : 0;
  }
  const Path<W>& path() const { return path_; }

 private:
  double sample(std::uint64_t i) {
    numbers_.start(i);
    choice_.start(i);
    double total = 0;
    sampler_.sample(numbers_, [&](const Path<W>& x, int, double weight) {
      total += weight;
      if (choice_.uniform() * total < weight) path_ = x;
    });
    return total;
  }

  PathSampler<Space> sampler_;
  Rng numbers_, choice_;
  Path<W> path_;
  double average_ = 0;
};

template <class Space, class Kernel>
InvarianceReport test_invariance(const Space& space, const Kernel& kernel,
                                 const InvarianceOptions& options) {
  using W = typename Space::Universe;
  Starts<Space> starts(space, options.seed);
  Rng random(options.seed, Purpose::test, 2);
  Deviations one_step(function_count), many_steps(function_count);
  Flux flux(cell_count);
  Moments acceptance;
  for (std::uint64_t i = 0; i < options.samples; ++i) {
    const double weight = starts.draw(i);
    if (!(weight > 0)) continue;
    const FunctionValues before = functions_of(space, starts.path());
    Chain<Space, Kernel> chain(space, kernel, starts.path());
    random.start(i);
    chain.step(random, [&](const Step<W>& step) {
      acceptance.add(step.acceptance);
      if (!(step.acceptance > 0)) return;
      const double flow = weight * step.acceptance;
      const FunctionValues after = functions_of(space, step.proposed);
      for (std::size_t k = 0; k < function_count; ++k)
        if (after[k] != before[k]) one_step.add(k, flow * (after[k] - before[k]));
      flux.add(cell_of(space, step.current), cell_of(space, step.proposed), flow);
    });
    for (int n = 1; n < options.steps; ++n) chain.step(random, [](const Step<W>&) {});
    const FunctionValues after = functions_of(space, chain.current());
    for (std::size_t k = 0; k < function_count; ++k)
      if (after[k] != before[k]) many_steps.add(k, weight * (after[k] - before[k]));
  }
  return {one_step.decide(options.samples, options.false_alarm),
          many_steps.decide(options.samples, options.false_alarm), flux.decide(options.false_alarm),
          acceptance.mean()};
}

// The kernel that consists of one mutation.
template <class Mutation>
Mixture<Mutation> alone(Mutation mutation) {
  return Mixture<Mutation>({1}, std::move(mutation));
}

}  // namespace wander::test
