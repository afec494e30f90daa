// What independent bidirectional samples found: the light of all paths, of each length and by each
// technique.  Where the space has a map v (importance_map.h), what they measured is f v and its
// light 1/v times as much.
#pragma once

#include <cstdint>
#include <vector>

#include "core/film.h"
#include "core/technique_table.h"
#include "statistics/sum.h"

namespace wander {

// A path that a sample found by technique (s,t): its bin, w f v/p, and the light that it shows, w f/p.
struct FoundPath {
  int bin, technique;  // s
  double measure, light;
};

// Σ and Σ² over samples, of all paths and of each length.
struct SeedTally {
  std::uint64_t samples = 0;
  std::uint64_t rays = 0;         // of walks and connections that were tried: what the samples cost
  std::vector<Sum> sum, squares;  // by vertices - 2
  Sum total, total_squares;
  Sum measure;                // Σ w f v/p: where there is no map, the same as `total`
  TechniqueTable techniques;  // of that, of each
  BinSums ends_met;           // by chance: light of three vertices and more by s = 0 or t = 0

  explicit SeedTally(int max_vertices)
      : sum(static_cast<std::size_t>(max_vertices) - 1),
        squares(sum.size()),
        techniques(max_vertices) {}
  void merge(const SeedTally& other) {
    samples += other.samples;
    rays += other.rays;
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum[k] += other.sum[k];
      squares[k] += other.squares[k];
    }
    total += other.total;
    measure += other.measure;
    total_squares += other.total_squares;
    ends_met.merge(other.ends_met);
    for (std::size_t i = 0; i < techniques.values().size(); ++i)
      techniques.values()[i] += other.techniques.values()[i];
  }
  // Of the paths of so many vertices.
  double mean(int vertices) const {
    const double total_of_length = sum[static_cast<std::size_t>(vertices) - 2].value();
    return samples > 0 ? total_of_length / static_cast<double>(samples) : 0;
  }
  double mean() const { return samples > 0 ? total.value() / static_cast<double>(samples) : 0; }
  // ∫ f v, which the target of chains is divided by
  double mean_measure() const {
    return samples > 0 ? measure.value() / static_cast<double>(samples) : 0;
  }
  // (Σ x)² / Σ x²: how many samples carry the estimate.
  double effective_samples() const {
    const double squared = total_squares.value();
    return squared > 0 ? total.value() * total.value() / squared : 0;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(samples, rays, sum, squares, total, total_squares, measure, techniques, ends_met);
  }
};

}  // namespace wander
