// What a mutation says of itself beside proposing.  All of it has a default; a mutation states what
// differs below its class,
//
//   template <>
//   inline constexpr Traits<Lens> traits<Lens>{.parameters = perturbation_parameters<Lens>};
//
// and a field that does not exist is an error of compilation.
#pragma once

#include <span>
#include <string_view>

#include "core/requirements.h"
#include "mlt/seeds/seed_tally.h"

namespace wander {

// The two ends of a range of distances, or twice the same number.
struct Ends {
  double smallest, largest;
};

// What can be set when a run is made: --mutations lens=1:angle=1e-5..0.1
template <class M>
struct Parameter {
  std::string_view name, meaning;  // meaning: with its unit
  double most;                     // allowed: above 0, up to this
  Ends (*ends)(const M& mutation);
  void (*set)(M& mutation, Ends ends);
};

template <class M>
struct Traits {
  // Of --mutations; several mutations may go by one word.
  std::string_view word = M::name;
  // Of its word, where the weights are `auto`.
  double auto_weight = 1;
  // Its part of the weight of its word; `large_step` is the share of large primary steps.
  double (*share)(double large_step) = [](double) { return 1.0; };
  // Why a scene has no use for it; empty if it has.
  std::string_view (*left_out)(const Requirements& scene) = [](const Requirements&) {
    return std::string_view{};
  };
  // The same mutation with moves so many times as far.
  M(*scaled)
  (const M& mutation, double factor) = [](const M& mutation, double) { return mutation; };
  // Before the chains start: what a seed pass found.  A kernel must learn from other seeds than
  // those its chains start from, or the film is biased.
  void (*learn)(M& mutation, const SeedTally& seeds) = [](M&, const SeedTally&) {};
  std::span<const Parameter<M>> parameters{};
};

template <class M>
inline constexpr Traits<M> traits{};

}  // namespace wander
