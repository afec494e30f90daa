// The chains of one group: the slice of the seed pass that they start from, and the random numbers
// of each.  All chains come from here: render() takes those of each group, and watches them with a
// film and statistics (group.h); trace and replay take those that they show (lab/shown_chains.h).
//
// Groups share nothing.  The constants of a group are those of its own slice: seeds and constants
// from one slice make the film unbiased for chains of any length (seed_pass.h).
#pragma once

#include <algorithm>
#include <concepts>
#include <span>
#include <string_view>

#include "core/rng.h"
#include "mlt/seeds/seed_pass.h"

namespace wander {

template <class C>
concept ChainSource = requires(C& chains, const C& made, std::uint64_t count,
                               const SeedTally& others) {
  chains.add_seeds(count);
  { made.seed_tally() } -> std::same_as<const SeedTally&>;  // of the samples with seeds
  { made.tally() } -> std::same_as<const SeedTally&>;
  // After the seed pass: of the chains for which there are seeds, only so many run.
  chains.keep_chains(1);
  // The seeds are drawn: samples after this are no candidates.
  chains.end_seeds();
  // After that; `others`: what all other groups found.
  chains.start_chains(others);
  // Can steps add anything to the film?
  { made.takes_steps() } -> std::same_as<bool>;
  { made.chains() } -> std::same_as<int>;
  C::move_names();  // of what its chains propose
};

// A chain and the stream of random numbers that is its own: each step has its place in it.
template <class Chain>
struct RunningChain {
  Chain chain;
  Rng random;
  std::uint64_t steps = 0;  // that it has made

  template <class Observer>
  void step(Observer&& observe) {
    step(random, observe);
  }
  // With a copy of its random numbers that is of another type, such as one that is watched.
  template <class Random, class Observer>
  void step(Random& same, Observer&& observe) {
    same.start(steps++);
    chain.step(same, observe);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(chain, steps);
  }
};

// Chains that share the steps of their group evenly, whatever the rounds they are made in.
class EvenTurns {
 public:
  explicit EvenTurns(int chains) : chains_(static_cast<std::uint64_t>(chains)) {}

  // step(k) for chain k, so many times in all.
  template <class Step>
  void take(std::uint64_t steps, Step&& step) {
    const std::uint64_t target = done_ + steps;
    const auto share = [this](std::uint64_t total, std::uint64_t k) {
      return total / chains_ + (k < total % chains_ ? 1 : 0);
    };
    for (std::uint64_t k = 0; k < chains_; ++k)
      for (std::uint64_t i = share(done_, k); i < share(target, k); ++i) step(k);
    done_ = target;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(done_);
  }

 private:
  std::uint64_t chains_, done_ = 0;
};

// What the deposits of a step are: shares of it that sum to one, of which the constant of the group
// makes light; or light.
enum class Deposits { shares, light };

// What the chains of all methods have in common.
template <class S, class SeedsOfSlice>
class SeededChains {
 public:
  using Space = S;
  using Seeds = SeedsOfSlice;

  template <class Watcher = NoWatcher>
  void add_seeds(std::uint64_t count, Watcher&& watcher = {}) {
    slice_.run(count, watcher);
  }
  void end_seeds() { slice_.end_seeds(); }
  const SeedTally& tally() const { return slice_.tally(); }
  const SeedTally& seed_tally() const { return slice_.seed_tally(); }
  const SeedEvidence& evidence() const { return slice_.evidence(); }
  bool found_light() const { return slice_.found_light(); }
  const Space& space() const { return space_; }

  // The slice, between two samples of the seed pass, or after it.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(slice_);
  }

  // May their target be f v, with a factor v of each bin?
  static constexpr bool may_have_even_target = false;

 protected:
  SeededChains(const Space& space, std::uint64_t seed, int group, int seeds,
               const FilmLayout& layout)
      : space_(space), seed_(seed), slice_(space, seed, group, seeds, layout) {}

  const Space& space_;
  std::uint64_t seed_;
  SeedSlice<Space, Seeds> slice_;
};

}  // namespace wander
