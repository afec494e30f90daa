// Metropolis–Hastings [Metropolis et al. 1953, Hastings 1970; Veach and Guibas 1997] on light
// paths, with the target density f(x) / b.
#pragma once

#include <utility>

#include "core/techniques.h"
#include "mlt/proposal.h"

namespace wander {

// a(x→y) = min(1, f(y) T(y→x) / (f(x) T(x→y))).  A ratio that is no positive number is refused.
inline double acceptance(Scaled f_x, Scaled forward, Scaled f_y, Scaled reverse) {
  const Scaled ratio = (f_y * reverse) / (f_x * forward);
  if (!ratio.is_positive()) return 0;
  const double a = ratio.value();
  return a < 1 ? a : 1;
}

// Everything that one step did.  Observers read it before the state moves, so the rejected proposal
// is still there; the chain knows none of them.
template <class W>
struct Step {
  const Path<W>& current;   // x
  const Path<W>& proposed;  // y; of use only if `outcome` is a Proposal
  int mutation;             // index in the mixture
  Proposed outcome;
  double acceptance;  // a(x→y); 0 when there is no proposal
  Reason reason;      // none: accepted
  bool accepted() const { return reason == Reason::none; }
};

// The step of any chain whose states are paths, as one of paths: this is one.
template <class W>
const Step<W>& path_step(const Step<W>& step) {
  return step;
}

template <class Space, class Kernel>
class Chain {
 public:
  using W = typename Space::Universe;

  // `seed` is a path with f > 0.
  Chain(const Space& space, const Kernel& kernel, const Path<W>& seed)
      : space_(&space),
        kernel_(&kernel),
        current_(space.max_vertices()),
        proposed_(space.max_vertices()) {
    current_ = seed;  // into memory that holds any path, so that no step allocates
    weigh(space, current_);
  }
  Chain(const Space&&, const Kernel&, const Path<W>&) = delete;
  Chain(const Space&, const Kernel&&, const Path<W>&) = delete;

  const Path<W>& current() const { return current_; }

  // The proposal of the step under way, made again in a space of another type, such as one that
  // watches; `random` is where the step began, and y takes the path.  Is it one to be weighed?
  template <class OtherSpace, class Random>
  bool propose_again(const OtherSpace& space, Path<W>& y, Random& random) const {
    return std::holds_alternative<Proposal>(kernel_->propose(space, current_, y, random).proposed);
  }

  // The state: what the last proposal left is of no use any more.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(current_);
  }

  template <class Random, class Observer>
  void step(Random& random, Observer&& observe) {
    auto [mutation, outcome] = kernel_->propose(*space_, current_, proposed_, random);
    Reason reason = Reason::metropolis;
    double a = 0;
    if (const Proposal* p = std::get_if<Proposal>(&outcome)) {
      if (!proposed_.is_weighed()) weigh(*space_, proposed_);
      const Reason flaw = flaw_of(*p);
      if (flaw != Reason::none) {
        outcome = Failure{flaw};
      } else {
        a = acceptance(current_.contribution, p->forward, proposed_.contribution, p->reverse);
        if (random.uniform() < a) reason = Reason::none;
      }
    }
    if (const Failure* failure = std::get_if<Failure>(&outcome)) reason = failure->reason;
    observe(Step<W>{current_, proposed_, mutation, outcome, a, reason});
    if (reason == Reason::none) std::swap(current_, proposed_);
  }

 private:
  // Why a proposal cannot be weighed, or `none`.
  Reason flaw_of(const Proposal& p) const {
    if (proposed_.contribution.is_zero()) return Reason::zero_contribution;
    if (!proposed_.contribution.is_positive() || !p.forward.is_positive())
      return Reason::not_finite;
    if (p.reverse.is_zero()) return Reason::not_reversible;
    return p.reverse.is_positive() ? Reason::none : Reason::not_finite;
  }

  const Space* space_;
  const Kernel* kernel_;
  Path<W> current_, proposed_;
};

}  // namespace wander
