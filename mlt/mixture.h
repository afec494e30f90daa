// A mutation made of mutations: one is selected, with probabilities that may depend on the state.
//
//   T(x→y) = Σ_i s_i(x) T_i(x→y),  s_i(x) = w_i a_i(x) / Σ_j w_j a_j(x)
//
// Each mutation is reversible by itself, so the term of the selected one is enough, but its
// selection probabilities at both ends belong in the ratio.
#pragma once

#include <array>
#include <tuple>
#include <utility>

#include "mlt/mutation.h"
#include "mlt/traits.h"

namespace wander {

// Mutations that are to join others in a mixture.
template <class... Mutations>
struct MutationList {};

template <class... Mutations>
class Mixture {
 public:
  static constexpr std::size_t count = sizeof...(Mutations);
  static constexpr std::array<std::string_view, count> names{Mutations::name...};

  struct Selected {
    int mutation;
    Proposed proposed;
  };

  Mixture(std::array<double, count> weights, Mutations... mutations)
      : weights_(weights), mutations_(std::move(mutations)...) {}

  template <class Space, class Random>
  Selected propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const auto selection = probabilities(space, x);
    // Where nothing is applicable, one that was asked for is told, as often as its weight says.
    if (selection == std::array<double, count>{})
      return {random.choose(normalized(weights_)), Failure{Reason::not_applicable}};
    const int selected = random.choose(selection);
    const auto index = static_cast<std::size_t>(selected);
    Proposed proposed =
        dispatch(index, [&](const auto& m) { return m.propose(space, x, y, random); });
    if (Proposal* p = std::get_if<Proposal>(&proposed)) {
      p->forward *= selection[index];
      p->reverse *= probabilities(space, y)[index];
    }
    return {selected, proposed};
  }

  // Before the chains start: what a seed pass found, for the mutations that can use it (traits.h).
  void learn(const SeedTally& seeds) {
    std::apply([&](Mutations&... m) { (traits<Mutations>.learn(m, seeds), ...); }, mutations_);
  }

  const std::array<double, count>& weights() const { return weights_; }
  template <class M>
  const M& get() const {
    return std::get<M>(mutations_);
  }
  // The same mutations, of which mutation i alone is ever selected.
  Mixture only(std::size_t i) const {
    Mixture one = *this;
    one.weights_ = {};
    one.weights_[i] = 1;
    return one;
  }

  // s_i(x); all zero where nothing is applicable.
  template <class Space>
  std::array<double, count> probabilities(const Space& space,
                                          const Path<typename Space::Universe>& x) const {
    std::array<double, count> s{};
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      ((s[i] = weights_[i] > 0 ? weights_[i] * std::get<i>(mutations_).applicability(space, x) : 0),
       ...);
    }
    (std::index_sequence_for<Mutations...>{});
    return normalized(s);
  }

 private:
  // All zero where they are.
  static std::array<double, count> normalized(std::array<double, count> s) {
    double total = 0;
    for (const double p : s) total += p;
    if (total > 0)
      for (double& p : s) p /= total;
    return s;
  }
  // Calls f with the mutation of that index.
  template <class F>
  Proposed dispatch(std::size_t index, F&& f) const {
    Proposed result = Failure{Reason::not_reversible};
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      ((i == index ? (result = f(std::get<i>(mutations_)), true) : false) || ...);
    }
    (std::index_sequence_for<Mutations...>{});
    return result;
  }

  std::array<double, count> weights_;
  std::tuple<Mutations...> mutations_;
};

// The mixture of all of them, those of the list last.
template <class Mixed, class List>
struct JoinedTo;
template <class... Ms, class... More>
struct JoinedTo<Mixture<Ms...>, MutationList<More...>> {
  using type = Mixture<Ms..., More...>;
};
template <class Mixed, class List>
using Joined = typename JoinedTo<Mixed, List>::type;

}  // namespace wander
