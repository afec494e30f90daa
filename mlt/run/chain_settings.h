// How the work of a Markov chain method is laid out.
#pragma once

#include <cstdint>

#include "mlt/run/normalization.h"

namespace wander {

struct ChainSettings {
  int groups = 64;  // independent: their spread is the error bar
  int chains_per_group = 4;
  // Fewer chains run, but one at least, where a budget would give each fewer steps than this: they
  // would be too short to mix.  0: all run, however short they are.
  std::uint64_t steps_per_chain = 1 << 16;
  double seed_share = 0.25;  // of the seed pass: samples per mutation, seconds per second of chains
  std::uint64_t fewest_seeds = 1 << 15;  // samples, of all groups together
  NormalizationMethod normalization = NormalizationMethod::bridge;
  FilmLayout film{};

  bool operator==(const ChainSettings&) const = default;
};

}  // namespace wander
