// One chain of MMLT, whose paths have n vertices [Hachisuka, Kaplanyan and Dachsbacher 2014], and
// the random numbers by which a group, with one chain for each length, starts and steps them.
#pragma once

#include "mlt/primary/multiplexed_path.h"
#include "mlt/seeds/seed_pass.h"

namespace wander {

template <class Space, class SmallStep>
class MultiplexedChain {
 public:
  using W = typename Space::Universe;
  using Sampler = MultiplexedSampler<Space>;

  // Starts in the dark.
  MultiplexedChain(const Space& space, const PrimaryKernel<SmallStep>& kernel, int vertices)
      : of_sample_(space.max_vertices()), sampler_(space, vertices), chain_(sampler_, kernel) {}

  // Starts at the path of a seed, whose weight must come out as it was, bit for bit.
  void start(SeedSlice<Space, LengthSeeds>& slice, const Seed& seed, double place) {
    const PrimaryNumbers numbers =
        sampler_.coordinates_of(slice.numbers(seed, of_sample_), of_sample_, seed.technique, place);
    if (!chain_.start(sampler_, numbers) ||
        chain_.current().total != sampler_.techniques() * seed.weight)
      throw SeedReplayError("a seed path could not be made again by its technique alone");
  }

  const MultiplexedPath<W>& current() const { return chain_.current(); }

  // As of a chain in path space (chain.h), but from the numbers that the proposal was made of: the
  // stream has nothing to add.
  template <class OtherSpace, class Random>
  bool propose_again(const OtherSpace& space, Path<W>&, Random&) const {
    const MultiplexedSampler<OtherSpace> sampler(space, sampler_.vertices());
    MultiplexedPath<W> y = sampler.make_sample();
    PrimarySource source(sampler.layout(),
                         [&](std::size_t k) { return chain_.proposed_numbers()[k]; });
    sampler.draw(source, y);
    return y.flaw == Reason::none;
  }

  template <class Archive>
  void save(Archive& archive) const {
    chain_.save(archive);
  }
  template <class Archive>
  void load(Archive& archive) {
    chain_.load(sampler_, archive);
  }

  // The observer gets a PrimaryStep of MultiplexedPath.
  template <class Random, class Observer>
  void step(Random& random, Observer&& observe) {
    chain_.step(sampler_, random, observe);
  }

 private:
  PrimaryLayout<W> of_sample_;
  Sampler sampler_;
  PrimaryChain<Sampler, SmallStep> chain_;
};

// The random numbers of a group with chains for so many lengths, that of n vertices at n - 2.
class LengthNumbers {
 public:
  LengthNumbers(std::uint64_t seed, int group, int lengths)
      : seed_(seed), first_stream_(group * lengths) {
    Rng choice(seed, Purpose::lengths, static_cast<std::uint32_t>(group));
    first_length_ = choice.uniform();
    for (int k = 0; k < lengths; ++k) places_.push_back(choice.uniform());
  }

  // Where the sequence of the lengths of steps begins.
  double first_length() const { return first_length_; }
  // Where in its cell the number lies that chooses the technique of the seed.
  double place(int k) const { return places_[static_cast<std::size_t>(k)]; }
  Rng chain(int k) const {
    return {seed_, Purpose::chain, static_cast<std::uint32_t>(first_stream_ + k)};
  }

 private:
  std::uint64_t seed_;
  int first_stream_;
  double first_length_;
  std::vector<double> places_;
};

}  // namespace wander
