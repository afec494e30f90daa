// A group of chains of PSSMLT [Kelemen et al. 2002]: the state is a whole bidirectional sample, the
// seeds are samples of the slice in proportion to C*, and b_g is the mean of C* over the slice.
#pragma once

#include "mlt/primary/primary_estimator.h"
#include "mlt/primary/sample_splats.h"
#include "mlt/run/group.h"

namespace wander {

template <class Space, class SmallStep, class Estimator>
class PssmltGroup : public SeededGroup<Space, SampleSeeds> {
 public:
  using W = typename Space::Universe;
  using Kernel = PrimaryKernel<SmallStep>;

  PssmltGroup(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains)
      : SeededGroup<Space, SampleSeeds>(space, seed, group, chains, move_names()),
        kernel_(kernel),
        sampler_(space),
        seed_(seed),
        first_chain_(group * chains),
        chain_count_(chains) {}

  static constexpr std::span<const std::string_view> move_names() { return primary_move_names; }
  bool takes_steps() const { return slice_.found_light() || !Estimator::needs_seed; }
  int chains() const { return chain_count_; }
  void keep_chains(int most) { chain_count_ = std::min(chain_count_, most); }

  void start_chains(const SeedTally& others) {
    constants_ = {this->tally().mean(), others.mean(), kernel_.large_step};
    if (!takes_steps()) return;
    this->expect_states();
    for (int k = 0; k < chain_count_; ++k) {
      chains_.push_back({PrimaryChain<SplatSampler<Space>, SmallStep>(sampler_, kernel_),
                         Rng(seed_, Purpose::chain, static_cast<std::uint32_t>(first_chain_ + k)),
                         RejectionRuns(primary_move_names.size())});
      if (slice_.found_light()) start(chains_.back(), slice_.seed(k));
    }
  }

  void advance(std::uint64_t steps) {
    this->share_evenly(steps, chains_.size(), [&](std::uint64_t k) { step(chains_[k]); });
  }

  void deliver(GroupsFilm& film, MutationStatistics& statistics, ChainDraws& draws) const {
    if (steps_ == 0) return film.add_dark_group();
    film.add(film_, 1, steps_);
    statistics.merge(statistics_);
    if (!slice_.found_light()) return;  // chains that began in the dark have draws of nothing
    for (const Member& member : chains_) draws.add(member.draws);
  }

  GroupFindings findings() const {
    const double scale = steps_ > 0 ? 1 / static_cast<double>(steps_) : 0;
    return this->findings_of(scale, [&](std::size_t) { return this->tally().mean(); });
  }

  // Into a group whose chains have started from the same slices.
  template <class Archive>
  void serialize_chains(Archive& archive) {
    this->serialize_steps(archive);
    for (Member& member : chains_) archive(member.chain, member.runs, member.draws, member.steps);
  }

 private:
  using Base = SeededGroup<Space, SampleSeeds>;
  using Base::film_;
  using Base::slice_;
  using Base::statistics_;
  using Base::steps_;

  struct Member {
    PrimaryChain<SplatSampler<Space>, SmallStep> chain;
    Rng random;
    RejectionRuns runs;
    ThinnedDraws draws{};
    std::uint64_t steps = 0;
  };

  // The sample of a seed, whose total must come out as it was, bit for bit.
  void start(Member& member, const Seed& seed) {
    const PrimaryNumbers numbers = slice_.numbers(seed, sampler_.layout());
    if (!member.chain.start(sampler_, numbers) || member.chain.current().total != seed.weight)
      throw SeedReplayError("a seed sample could not be replayed from its random numbers");
  }

  void step(Member& member) {
    member.random.start(member.steps);
    statistics_.timed(member.steps++, [&] {
      int move = 0;
      member.chain.step(sampler_, member.random, [&](const PrimaryStep<SampleSplats>& step) {
        deposit(step, Estimator::deposit(step, constants_), film_);
        statistics_.observe(
            primary_observation(step, step.current.brightest(), step.proposed.brightest()),
            member.runs);
        move = step.mutation();
      });
      return move;
    });
    if (!slice_.found_light()) return;
    const SampleSplats& current = member.chain.current();
    this->keep_state(0, current.total);
    member.draws.offer([&] { return functionals(current.brightest(), std::log(current.total)); });
  }

  Kernel kernel_;
  SplatSampler<Space> sampler_;
  std::uint64_t seed_;
  int first_chain_, chain_count_;
  PrimaryConstants constants_{};
  std::vector<Member> chains_;
};

}  // namespace wander
