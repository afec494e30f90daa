// A Markov chain in primary sample space [Kelemen et al. 2002]: u in [0,1)^m, target C*(u) / b,
// where a sampler turns u into something that carries light, and into its total C*(u).
//
// Proposal v.  Large step: v_k fresh and uniform.  Small step: v_k = u_k moved by a symmetric
// kernel K, if the sampler used coordinate k to make the current state; fresh and uniform
// otherwise. Coordinates are drawn when the sampler asks for them.  Measure: du.
//
// How many coordinates a sample uses depends on its numbers, yet a(u→v) = min(1, C*(v) / C*(u))
// exactly, and no coordinate needs a history.  A state is u_A, with A the coordinates that the
// sampler asks for when it is given u_A; its measure is du_A, and what it does not use it does not
// keep.  A small step from u_A arrives at v_B with density
//   Π_{k in A ∩ B} K(u_k→v_k) Π_{k in B \ A} 1,
// for no number is drawn that v does not use.  Back from v_B to u_A it is Π_{k in A ∩ B} K(v_k→u_k)
// Π_{k in A \ B} 1: the same.
//
// A state with C* = 0 is left for any that carries light.  No estimate starts from one, except that
// of independent large steps (primary_estimator.h), to which the state does not matter.
#pragma once

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "mlt/chain.h"
#include "mlt/primary/primary_numbers.h"
#include "mlt/watch/statistics.h"

namespace wander {

enum class PrimaryMove { small, large };
inline constexpr std::array<std::string_view, 2> primary_move_names{"primary_small",
                                                                    "primary_large"};

// What proposes.  SmallStep::move(u, random) answers with {u, density} of a symmetric kernel on the
// circle [0,1).
template <class SmallStep>
struct PrimaryKernel {
  SmallStep small_step;
  double large_step;  // probability
};

// Everything that one step did, as observers see it before the state moves.
template <class Sample>
struct PrimaryStep {
  const Sample& current;
  const Sample& proposed;
  PrimaryMove move;
  Scaled density;  // of the move and its numbers, the same both ways
  double acceptance;
  Reason reason;  // none: accepted
  bool accepted() const { return reason == Reason::none; }
  int mutation() const { return static_cast<int>(move); }
};

// For the statistics, with what stands for the states x and y.
template <class Sample>
Observation primary_observation(const PrimaryStep<Sample>& step, const Features& x,
                                const Features& y) {
  const bool moves = step.acceptance > 0 && !x.is_dark();
  return {step.mutation(), step.reason, step.acceptance, x,
          moves ? step.acceptance * squared_jump(x, y) : 0};
}

// A sampler S has
//   S::W, S::Sample     the world; what it makes, with `total` = C* and, where that is 0, a `flaw`
//   layout(), coordinates(), make_sample()
//   draw(random, sample)  makes a sample of the numbers of `random`; does not allocate
template <class Sampler, class SmallStep>
class PrimaryChain {
 public:
  using W = typename Sampler::W;
  using Sample = typename Sampler::Sample;

  // Starts in the dark.
  PrimaryChain(const Sampler& sampler, const PrimaryKernel<SmallStep>& kernel)
      : kernel_(kernel), current_(sampler), proposed_(sampler) {}

  const Sample& current() const { return current_.sample; }
  const PrimaryNumbers& numbers() const { return current_.numbers; }
  // While a step is observed.
  const PrimaryNumbers& proposed_numbers() const { return proposed_.numbers; }

  // The state is its numbers, for they make the same sample again: what the last proposal left is of no
  // use any more.
  template <class Archive>
  void save(Archive& archive) const {
    archive(numbers());
  }
  template <class Archive>
  void load(Sampler& sampler, Archive& archive) {
    PrimaryNumbers numbers(sampler.coordinates());
    archive(numbers);
    if (!numbers.is_empty() && !start(sampler, numbers))
      throw std::runtime_error("the numbers of a chain do not make its sample again");
  }

  // Starts at the sample of these numbers.  False: they are not all that the sampler asks for.
  bool start(Sampler& sampler, const PrimaryNumbers& numbers) {
    bool complete = true;
    current_.numbers = numbers;
    PrimarySource source(sampler.layout(), [&](std::size_t k) {
      complete = complete && numbers.holds(k);
      return numbers[k];
    });
    sampler.draw(source, current_.sample);
    return complete;
  }

  template <class Random, class Observer>
  void step(Sampler& sampler, Random& random, Observer&& observe) {
    const bool is_large = random.uniform() < kernel_.large_step;
    const PrimaryMove move = is_large ? PrimaryMove::large : PrimaryMove::small;
    const Scaled density = propose(sampler, move, random);
    const double a = acceptance_of(current_.sample.total, proposed_.sample.total);
    Reason reason = proposed_.sample.flaw;
    if (reason == Reason::none && !(random.uniform() < a)) reason = Reason::metropolis;
    observe(PrimaryStep<Sample>{current_.sample, proposed_.sample, move, density, a, reason});
    if (reason == Reason::none) std::swap(current_, proposed_);
  }

 private:
  struct State {
    PrimaryNumbers numbers;
    Sample sample;
    explicit State(const Sampler& sampler)
        : numbers(sampler.coordinates()), sample(sampler.make_sample()) {}
  };

  static double acceptance_of(double from, double to) {
    return from > 0 ? acceptance(from, 1, to, 1) : to > 0 ? 1 : 0;
  }

  // Makes the proposed sample; the density of its moves.
  template <class Random>
  Scaled propose(Sampler& sampler, PrimaryMove move, Random& random) {
    const bool is_small = move == PrimaryMove::small;
    Scaled density = is_small ? 1 - kernel_.large_step : kernel_.large_step;
    proposed_.numbers.clear();
    PrimarySource source(sampler.layout(), [&](std::size_t k) {
      double u = 0;
      if (is_small && current_.numbers.holds(k)) {
        const auto moved = kernel_.small_step.move(current_.numbers[k], random);
        u = moved.u;
        density *= moved.density;
      } else {
        u = random.uniform();
      }
      proposed_.numbers.set(k, u);
      return u;
    });
    sampler.draw(source, proposed_.sample);
    return density;
  }

  PrimaryKernel<SmallStep> kernel_;
  State current_, proposed_;
};

}  // namespace wander
