// What the seed pass draws for the chains, in one sweep by weighted reservoirs [Chao 1982]: paths,
// paths of each length, or whole samples, in proportion to w f / p.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/path_space.h"
#include "core/rng.h"
#include "mlt/seeds/seed_tally.h"
#include "statistics/sum.h"

namespace wander {

// A path of the seed pass: sample index and technique find it again, `weight` proves it.  Of a
// whole sample: no vertices, and the weight is that of all its paths.
struct Seed {
  std::uint64_t sample = 0;
  int vertices = 0, technique = 0;
  double weight = 0;  // w f / p

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sample, vertices, technique, weight);
  }
};

// What the target density of a chain is divided by: the intensity of paths per sample, or that of
// samples, which is one.
enum class Ratios { of_paths, of_samples };

// Independent draws from one stream of candidates: each replaces each seed with probability w_i / W_i, where
// W_i is the sum of the weights so far.  A seed taken at W_a outlives all candidates up to i with probability
//   Π_{a<j≤i} (1 - w_j / W_j) = W_a / W_i,
// so one number u, drawn when it is taken, says which replaces it: the first with W_i > W_a / (1 - u)
// [as the jumps of Efraimidis and Spirakis 2006].
class Reservoirs {
 public:
  explicit Reservoirs(int count) : kept_(static_cast<std::size_t>(count)) {}

  template <class Random>
  void offer(const Seed& candidate, Random& random) {
    total_ += candidate.weight;
    const double total = total_.value();
    if (!(total > first_end_)) return;
    first_end_ = std::numeric_limits<double>::infinity();
    for (Kept& kept : kept_) {
      if (total > kept.end) kept = {candidate, total / (1 - random.uniform())};
      first_end_ = std::min(first_end_, kept.end);
    }
  }
  const Seed& operator[](int i) const { return kept_[static_cast<std::size_t>(i)].seed; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(kept_, total_, first_end_);
  }

 private:
  struct Kept {
    Seed seed{};
    double end = 0;  // of the sums up to which it stays

    template <class Archive>
    void serialize(Archive& archive) {
      archive(seed, end);
    }
  };
  std::vector<Kept> kept_;
  Sum total_;
  double first_end_ = 0;
};

// Beside drawing, each kind of seeds says among which strata the states of its chains are compared
// with the seed pass (bridge.h), by the ratios of what it found: one stratum for each target
// density that the chains have; how much a slice has found of what a stratum's target measures; and whether the walks
// of samples play Russian roulette: so do those of a chain whose state is a whole sample, whose cost would
// else grow with the square of max_vertices; a chain of one length has no use for it.

// The seeds of chains whose state is a path of any length.
class PathSeeds {
 public:
  static int strata(int) { return 1; }
  static constexpr Roulette roulette = Roulette::by_albedo;
  static constexpr Ratios ratios = Ratios::of_paths;
  static std::size_t stratum(int) { return 0; }
  static double measure(const SeedTally& tally, std::size_t) { return tally.mean_measure(); }

  PathSeeds(Rng random, int chains) : random_(random), reservoirs_(chains) {}
  void start(std::uint64_t sample) { random_.start(sample); }
  void offer_path(const Seed& path) { reservoirs_.offer(path, random_); }
  void offer_sample(const Seed&) {}
  const Seed& operator[](int chain) const { return reservoirs_[chain]; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(reservoirs_);
  }

 private:
  Rng random_;
  Reservoirs reservoirs_;
};

// The seeds of chains whose state is a whole sample.
class SampleSeeds {
 public:
  static int strata(int) { return 1; }
  static constexpr Roulette roulette = Roulette::by_albedo;
  static constexpr Ratios ratios = Ratios::of_samples;
  static std::size_t stratum(int) { return 0; }
  static double measure(const SeedTally& tally, std::size_t) { return tally.mean(); }

  SampleSeeds(Rng random, int chains) : random_(random), reservoirs_(chains) {}
  void start(std::uint64_t sample) { random_.start(sample); }
  void offer_path(const Seed&) {}
  void offer_sample(const Seed& sample) { reservoirs_.offer(sample, random_); }
  const Seed& operator[](int chain) const { return reservoirs_[chain]; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(reservoirs_);
  }

 private:
  Rng random_;
  Reservoirs reservoirs_;
};

// One seed for each length: of paths of n vertices at n - 2, of weight 0 if there are none.
class LengthSeeds {
 public:
  static int strata(int max_vertices) { return max_vertices - 1; }
  static constexpr Roulette roulette = Roulette::off;
  static constexpr Ratios ratios = Ratios::of_paths;
  static std::size_t stratum(int vertices) { return static_cast<std::size_t>(vertices) - 2; }
  static double measure(const SeedTally& tally, std::size_t stratum) {
    return tally.mean(static_cast<int>(stratum) + 2);
  }

  LengthSeeds(Rng random, int lengths)
      : random_(random), reservoirs_(static_cast<std::size_t>(lengths), Reservoirs(1)) {}
  void start(std::uint64_t sample) { random_.start(sample); }
  void offer_path(const Seed& path) {
    reservoirs_[static_cast<std::size_t>(path.vertices) - 2].offer(path, random_);
  }
  void offer_sample(const Seed&) {}
  const Seed& operator[](int length) const {
    return reservoirs_[static_cast<std::size_t>(length)][0];
  }

  template <class Archive>
  void serialize(Archive& archive) {
    for (Reservoirs& reservoir : reservoirs_) archive(reservoir);
  }

 private:
  Rng random_;
  std::vector<Reservoirs> reservoirs_;
};

}  // namespace wander
