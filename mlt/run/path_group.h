// A group of chains in path space: expected values of steps of one kernel, scaled by b_g.
#pragma once

#include "mlt/chain.h"
#include "mlt/run/group.h"

namespace wander {

template <class Space, class Kernel>
class PathGroup : public SeededGroup<Space, PathSeeds> {
 public:
  using W = typename Space::Universe;

  PathGroup(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains)
      : SeededGroup<Space, PathSeeds>(space, seed, group, chains, Kernel::names),
        kernel_(kernel),
        seed_(seed),
        first_chain_(group * chains),
        chain_count_(chains) {}

  static constexpr std::span<const std::string_view> move_names() { return Kernel::names; }
  bool takes_steps() const { return slice_.found_light(); }
  int chains() const { return chain_count_; }
  void keep_chains(int most) { chain_count_ = std::min(chain_count_, most); }

  void start_chains(const SeedTally& others) {
    if (!slice_.found_light()) return;
    this->expect_states();
    kernel_.learn(others);
    for (int k = 0; k < chain_count_; ++k) {
      const Path<W> path = slice_.replay(slice_.seed(k), space_.max_vertices());
      chains_.push_back({Chain<Space, Kernel>(space_, kernel_, path),
                         Rng(seed_, Purpose::chain, static_cast<std::uint32_t>(first_chain_ + k)),
                         features(space_, path), RejectionRuns(Kernel::count)});
    }
  }

  void advance(std::uint64_t steps) {
    this->share_evenly(steps, chains_.size(), [&](std::uint64_t k) { step(chains_[k]); });
  }

  void deliver(GroupsFilm& film, MutationStatistics& statistics, ChainDraws& draws) const {
    if (steps_ == 0) return film.add_dark_group();
    film.add(film_, this->tally().mean(), steps_);
    statistics.merge(statistics_);
    for (const Member& member : chains_) draws.add(member.draws);
  }

  GroupFindings findings() const {
    const double scale = steps_ > 0 ? this->tally().mean() / static_cast<double>(steps_) : 0;
    auto found = this->findings_of(scale, [&](std::size_t) { return this->tally().mean(); });
    for (const auto& visits : statistics_.visits())
      found.classes.push_back({visits.path_class, scale * static_cast<double>(visits.steps)});
    return found;
  }

  // Into a group whose chains have started from the same slices.
  template <class Archive>
  void serialize_chains(Archive& archive) {
    this->serialize_steps(archive);
    for (Member& member : chains_)
      archive(member.chain, member.current, member.runs, member.draws, member.steps);
  }

 private:
  using Base = SeededGroup<Space, PathSeeds>;
  using Base::film_;
  using Base::slice_;
  using Base::space_;
  using Base::statistics_;
  using Base::steps_;

  struct Member {
    Chain<Space, Kernel> chain;
    Rng random;
    Features current;
    RejectionRuns runs;
    ThinnedDraws draws{};
    std::uint64_t steps = 0;
  };

  void step(Member& member) {
    member.random.start(member.steps);
    statistics_.timed(member.steps++, [&] {
      int mutation = 0;
      member.chain.step(member.random, [&](const Step<W>& step) {
        deposit(space_, step, member.current.bin, film_);
        statistics_.observe(observation(space_, step, member.current), member.runs);
        if (step.accepted()) member.current = features(space_, step.proposed);
        mutation = step.mutation;
      });
      return mutation;
    });
    const Path<W>& state = member.chain.current();
    this->keep_state(0, (state.contribution / state.intensity).value());
    member.draws.offer([&] { return functionals(space_, state); });
  }

  Kernel kernel_;
  std::uint64_t seed_;
  int first_chain_, chain_count_;
  std::vector<Member> chains_;
};

}  // namespace wander
