// How the work of a Markov chain method is laid out.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "mlt/run/normalization.h"

namespace wander {

// What is kept of the film: that of the chains alone, or of samples and chains together (partition.h);
// or of a large film nothing but its raster.
enum class FilmParts { chains, pooled, raster };

// Of the chains of mlt on an image: f v, which is about even over the film (test_image.h), or f, the light.
enum class Target { even, light };

// Where samples hardly find light (partition.h) a film is as good as they are many: they tell how bright it is, and
// where chains start, which hardly leave the places where they do.  So the seed pass is long, and chains are many.
struct RareLight {
  // Of the seed pass: seconds per second of chains, samples per mutation of a given number.
  static constexpr double seed_share_of_time = 1, samples_per_step = 4;
  static constexpr int chains_per_group = 8;
  static constexpr std::uint64_t steps_per_chain = 1 << 14;
};

// Of a pooled film that is an image.  A chain that is caught shows as a bright pixel, the fainter the more chains
// there are; and that they have few steps to forget where they began costs little, for they begin as all samples of
// the run say (docs/pooled-film.md).
struct ChainsOfImage {
  static constexpr int chains_per_group = 64;
  static constexpr std::uint64_t steps_per_chain = 1 << 10;
  // Where the pilot chooses more samples than steps what is left to chains is rare light, and one of few would be brighter than what
  // a sample finds.
  static constexpr std::uint64_t steps_per_chain_of_rare_light = 1 << 7;
};
// Paths of more vertices take more memory, and there are fewer of them: so many in a group.
constexpr int chains_in_memory(int chains_per_group, int max_vertices) {
  constexpr int vertices = 32, fewest = 4;
  return std::max(std::min(chains_per_group, fewest),
                  chains_per_group * vertices / std::max(max_vertices, vertices));
}

struct ChainSettings {
  int groups = 64;  // independent: their spread is the error bar
  int chains_per_group = 4;
  // Fewer chains run, but one at least, where a budget would give each fewer steps than this: they
  // would be too short to mix.  0: all run, however short they are.
  std::uint64_t steps_per_chain = 1 << 16;
  FilmParts film_parts = FilmParts::chains;
  Target target = Target::even;
  // Of the seed pass: samples per mutation, seconds per second of chains.  None: as many as a pilot
  // finds best, for a pooled film, or else the usual.
  std::optional<double> seed_share{};
  static constexpr double usual_seed_share = 0.25;
  std::uint64_t fewest_seeds = 1 << 15;  // samples, of all groups together
  // Of samples that no share asks for: where they are paths of hundreds of vertices without roulette, whose
  // square is what a sample costs, fewer must do.
  static constexpr std::uint64_t most_rays = 1 << 23;
  NormalizationMethod normalization = NormalizationMethod::bridge;
  FilmLayout film{};

  bool has_given_chains() const { return steps_per_chain == 0; }
  // Of each group, where all make so many steps together.
  int chains_for(std::uint64_t steps) const {
    if (has_given_chains()) return chains_per_group;
    const std::uint64_t enough = steps / steps_per_chain / static_cast<std::uint64_t>(groups);
    return static_cast<int>(
        std::clamp<std::uint64_t>(enough, 1, static_cast<std::uint64_t>(chains_per_group)));
  }

  bool operator==(const ChainSettings&) const = default;
};

}  // namespace wander
