// Chains of PSSMLT [Kelemen et al. 2002]: the state is a whole bidirectional sample, the seeds are
// samples of the slice in proportion to C*, and b_g is the mean of C* over the slice.
#pragma once

#include <cmath>

#include "mlt/primary/primary_estimator.h"
#include "mlt/primary/sample_splats.h"
#include "mlt/run/group.h"

namespace wander {

// A chain of whole samples, made by a sampler that it shares with others of its group.
template <class Space, class SmallStep>
class SampleChain {
 public:
  using Sampler = SplatSampler<Space>;

  // Starts in the dark.
  SampleChain(Sampler& sampler, const PrimaryKernel<SmallStep>& kernel)
      : sampler_(&sampler), chain_(sampler, kernel) {}

  // Starts at the sample of a seed, whose total must come out as it was, bit for bit.
  void start(SeedSlice<Space, SampleSeeds>& slice, const Seed& seed) {
    if (!chain_.start(*sampler_, slice.numbers(seed, sampler_->layout())) ||
        current().total != seed.weight)
      throw SeedReplayError("a seed sample could not be replayed from its random numbers");
  }

  const typename Sampler::Sample& current() const { return chain_.current(); }

  template <class Archive>
  void save(Archive& archive) const {
    chain_.save(archive);
  }
  template <class Archive>
  void load(Archive& archive) {
    chain_.load(*sampler_, archive);
  }

  // The observer gets a PrimaryStep of SampleSplats.
  template <class Random, class Observer>
  void step(Random& random, Observer&& observe) {
    chain_.step(*sampler_, random, observe);
  }

 private:
  Sampler* sampler_;
  PrimaryChain<Sampler, SmallStep> chain_;
};

template <class Space, class SmallStep, class Estimator>
class PssmltChains : public SeededChains<Space, SampleSeeds> {
 public:
  using Splats = SampleSplats<typename Space::Universe>;
  using Kernel = PrimaryKernel<SmallStep>;
  using Chain = SampleChain<Space, SmallStep>;
  using Turns = EvenTurns;
  static constexpr Deposits deposits = Deposits::light;
  static constexpr bool has_comparable_chains = true;

  PssmltChains(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains,
               const FilmLayout& layout = {})
      : SeededChains<Space, SampleSeeds>(space, seed, group, chains, layout),
        kernel_(kernel),
        sampler_(space),
        first_chain_(group * chains),
        chain_count_(chains) {}

  static constexpr std::span<const std::string_view> move_names() { return primary_move_names; }
  bool takes_steps() const { return slice_.found_light() || !Estimator::needs_seed; }
  int chains() const { return chain_count_; }
  void keep_chains(int most) { chain_count_ = std::min(chain_count_, most); }
  void start_chains(const SeedTally& others) {
    constants_ = {this->seed_tally().mean(), others.mean(), kernel_.large_step};
  }

  static std::size_t stratum(int) { return 0; }
  // As it starts.
  RunningChain<Chain> chain(int k) {
    Chain chain(sampler_, kernel_);
    if (slice_.found_light()) chain.start(slice_, slice_.seed(k));
    return {std::move(chain),
            Rng(seed_, Purpose::chain, static_cast<std::uint32_t>(first_chain_ + k))};
  }
  Turns turns() const { return Turns(chain_count_); }

  // ---- for those who watch

  template <class Put>
  void for_each_deposit(int, const PrimaryStep<Splats>& step, const Features&, Put&& put) const {
    wander::for_each_deposit(step, Estimator::deposit(step, constants_), put);
  }
  Observation observation(const PrimaryStep<Splats>& step, const Features& current) const {
    return primary_observation(step, current, features_of(step.proposed));
  }
  Features features_of(const Splats& sample) const { return sample.brightest(); }
  double ratio(const Splats& sample) const { return sample.total; }
  Functionals functionals_of(const Splats& sample) const {
    return functionals(features_of(sample), std::log(sample.total));
  }

 private:
  using Base = SeededChains<Space, SampleSeeds>;
  using Base::seed_;
  using Base::slice_;

  Kernel kernel_;
  SplatSampler<Space> sampler_;
  int first_chain_, chain_count_;
  PrimaryConstants constants_{};
};

template <class Space, class SmallStep, class Estimator>
using PssmltGroup = ChainGroup<PssmltChains<Space, SmallStep, Estimator>>;

}  // namespace wander
