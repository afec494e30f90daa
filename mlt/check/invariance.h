// Does a kernel leave f invariant?  Two engines on independent samples of paths, without a
// converged chain, a normalization or a reference [Veach 1997, 11.3.1; the ERPT identity of Cline
// et al. 2005].
//
// Invariance.  Let x_0 have the weight v of starts.h, E[v h(x_0)] = ∫ c f h, and let x_n follow n
// steps of a kernel that is reversible with respect to f, hence so are its powers.  Then
//   E[ v c(x_n) (h(x_n) - h(x_0)) ] = 0        for every bounded h,
// for c f(x) K^n(x→y) c(y) is symmetric.  After one step x_1 is y with probability a, so
// a c(y) (h(y) - h(x_0)) stands for its expectation.
//
// Flux.  With S_ij = Σ v a c(y) [x_0 in cell i, y in cell j], detailed balance makes S_ij and S_ji
// equal in expectation.
//
// An error is relative to what is compared: to Σ v c(x_0) h(x_0), or to the mean of both flows.
//
// Each decision is over z = S / √(Σ D² + M |S| / 2), with S = Σ D and M the heaviest start: no |D|
// exceeds M.  The second term (Bernstein's) is for what events too rare to be seen have kept from
// Σ D²: without it, flow that is seen in one direction and not in the other would look like a
// certain flaw.  With it, a Poisson count of 50 against its mean keeps the normal tail at 6σ.
#pragma once

#include <cstdint>
#include <vector>

#include "mlt/chain.h"
#include "mlt/check/path_functions.h"
#include "mlt/check/starts.h"
#include "statistics/decision.h"
#include "statistics/sum.h"
#include "work/parallel.h"

namespace wander {

// A function or a pair of cells takes part when Σ |D| is at least this many of the heaviest starts:
// about as many are needed before any flaw of it can be told.
inline constexpr double fewest_contributions = 30;
// The detail of a decision without comparisons, which has not passed.
inline constexpr const char* nothing_moved = "nothing moved often enough";

// Sums over samples of the deviations D of many functions, most of which are zero most of the time.
class Deviations {
 public:
  Deviations() : sums_(function_count) {}

  void add(const FunctionValues& before, const FunctionValues& after, double weight) {
    for (std::size_t k = 0; k < function_count; ++k)
      if (after[k] != before[k]) add(k, weight * (after[k] - before[k]));
  }
  // A start, whether it moves or not.
  void add_level(const FunctionValues& before, double weight) {
    for (std::size_t k = 0; k < function_count; ++k) sums_[k].level += weight * before[k];
  }
  void merge(const Deviations& other);
  // The worst comparison is a number of name_of_function().
  Decision decide(double heaviest, double false_alarm) const;

 private:
  struct Sums {
    double value = 0, magnitude = 0, square = 0;
    double level = 0;  // Σ v c(x_0) h(x_0)
  };
  void add(std::size_t function, double d) {
    Sums& s = sums_[function];
    s.value += d;
    s.magnitude += std::abs(d);
    s.square += d * d;
  }
  std::vector<Sums> sums_;
};

// Flux between the cells of a partition.
class Flux {
 public:
  Flux() : entries_(cell_count * cell_count) {}

  void add(std::size_t from, std::size_t to, double flow) {
    Entry& e = entries_[from * cell_count + to];
    e.flow += flow;
    e.square += flow * flow;
  }
  void merge(const Flux& other);
  // D = S_ij - S_ji.  The worst comparison is i · cell_count + j.
  Decision decide(double heaviest, double false_alarm) const;

 private:
  struct Entry {
    double flow = 0, square = 0;
  };
  std::vector<Entry> entries_;
};

struct InvarianceOptions {
  std::uint64_t samples = 60'000;
  int steps = 20;
  std::uint64_t seed = 1;
  double false_alarm = 1e-7;  // of each of the three decisions
};

struct InvarianceReport {
  Decision one_step, many_steps, flux;
  std::uint64_t starts = 0;  // paths from which the kernel was tried
  std::uint64_t acted = 0;   // on which some mutation of it can act
  std::uint64_t moved = 0;   // that it moved with a positive probability
  double acceptance = 0;     // mean a of the first steps

  bool all_pass() const { return one_step.passed && many_steps.passed && flux.passed; }
};

// What the starts of one block came to; blocks are merged in their order.
struct InvarianceTally {
  Deviations one_step, many_steps;
  Flux flux;
  double heaviest = 0;
  std::uint64_t starts = 0, acted = 0, moved = 0;
  Sum acceptance;

  void merge(const InvarianceTally& other);
  InvarianceReport report(double false_alarm) const;
};

template <class Space, class Kernel>
class InvarianceTest {
 public:
  using W = typename Space::Universe;

  // `starts` have found light.
  InvarianceTest(const Space& space, const Kernel& kernel, const Starts<Space>& starts,
                 const InvarianceOptions& options)
      : space_(space), kernel_(kernel), starts_(starts), options_(options), functions_(space) {}

  InvarianceReport run(const Run& run) const {
    std::vector<InvarianceTally> tallies(blocks);
    run_parallel(run, blocks, [&](int b) {
      const auto block = static_cast<std::uint64_t>(b);
      add_starts(run, options_.samples * block / blocks, options_.samples * (block + 1) / blocks,
                 tallies[block]);
    });
    for (int b = 1; b < blocks; ++b) tallies[0].merge(tallies[static_cast<std::size_t>(b)]);
    return tallies[0].report(options_.false_alarm);
  }

 private:
  static constexpr int blocks = 64;

  void add_starts(const Run& run, std::uint64_t first, std::uint64_t end,
                  InvarianceTally& tally) const {
    Starts<Space> starts = starts_;
    Rng random(options_.seed, Purpose::test, 2);
    Path<W> measured(space_.max_vertices());
    for (std::uint64_t i = first; i < end && !run.is_interrupted(); ++i) {
      const double weight = starts.draw(i);
      if (!(weight > 0)) continue;
      random.start(i);
      add_start(starts, weight, random, measured, tally);
    }
  }

  void add_start(const Starts<Space>& starts, double weight, Rng& random, Path<W>& measured,
                 InvarianceTally& tally) const {
    const FunctionValues before = functions_.values(starts.path());
    Chain<Space, Kernel> chain(space_, kernel_, starts.path());
    tally.heaviest = std::max(tally.heaviest, weight);
    ++tally.starts;
    for (Deviations* deviations : {&tally.one_step, &tally.many_steps})
      deviations->add_level(before, weight * starts.clip(chain.current()));
    double able = 0;
    for (const double s : kernel_.probabilities(space_, chain.current())) able += s;
    if (able > 0) ++tally.acted;
    chain.step(random, [&](const Step<W>& step) {
      tally.acceptance += step.acceptance;
      if (!(step.acceptance > 0)) return;
      ++tally.moved;
      measured = step.proposed;
      weigh(space_, measured);
      const double flow = weight * step.acceptance * starts.clip(measured);
      tally.one_step.add(before, functions_.values(measured), flow);
      tally.flux.add(functions_.cell(step.current), functions_.cell(measured), flow);
    });
    for (int n = 1; n < options_.steps; ++n) chain.step(random, [](const Step<W>&) {});
    tally.many_steps.add(before, functions_.values(chain.current()),
                         weight * starts.clip(chain.current()));
  }

  const Space& space_;
  const Kernel& kernel_;
  const Starts<Space>& starts_;
  InvarianceOptions options_;
  PathFunctions<Space> functions_;
};

}  // namespace wander
