// The groups of chains of a run, at work: seeds, starts and steps, on all threads.  Of groups that
// have chains alone, and nothing that watches them, seeds and starts (lab/shown_chains.h).
#pragma once

#include <memory>
#include <vector>

#include "mlt/run/chain_settings.h"
#include "mlt/run/group.h"
#include "work/parallel.h"

namespace wander {

template <class Space, ChainSource Chains>
class ChainGroups {
 public:
  template <class Kernel>
  ChainGroups(const Space& space, const Kernel& kernel, const Run& run,
              const ChainSettings& settings)
      : max_vertices_(space.max_vertices()), run_(run) {
    for (int g = 0; g < settings.groups; ++g)
      groups_.push_back(std::make_unique<Chains>(space, kernel, run.session().seed, g,
                                                 settings.chains_per_group));
  }

  auto begin() const { return groups_.begin(); }
  auto end() const { return groups_.end(); }
  std::uint64_t count() const { return groups_.size(); }
  Chains& operator[](int group) const { return *groups_[static_cast<std::size_t>(group)]; }

  // The seed pass: so many more samples of each slice.
  void add_seeds(std::uint64_t count) {
    on_all_threads([&](std::size_t g) { groups_[g]->add_seeds(count); });
  }
  SeedTally tally() const {
    SeedTally tally(max_vertices_);
    for (const auto& group : groups_) tally.merge(group->tally());
    return tally;
  }

  // After the seed pass; so many chains of each group.
  void start(int chains) {
    is_started_ = true;
    on_all_threads([&](std::size_t g) {
      SeedTally others(max_vertices_);
      for (std::size_t h = 0; h < groups_.size(); ++h)
        if (h != g) others.merge(groups_[h]->tally());
      groups_[g]->keep_chains(chains);
      groups_[g]->start_chains(others);
    });
    for (const auto& group : groups_)
      if (group->takes_steps()) active_.push_back(group.get());
  }

  bool is_started() const { return is_started_; }

  // The slices of the seed pass; and after start() from the same slices, what the steps have left.
  template <class Archive>
  void serialize_seeds(Archive& archive) {
    for (const auto& group : groups_) group->serialize_seeds(archive);
  }
  template <class Archive>
  void serialize_chains(Archive& archive) {
    archive(steps_);
    for (const auto& group : groups_) group->serialize_chains(archive);
  }

  // Steps of all chains together, shared evenly by the groups that take any.
  std::uint64_t steps() const { return steps_; }
  std::uint64_t active() const { return active_.size(); }
  void advance_to(std::uint64_t target) requires Group<Chains> {
    const std::uint64_t count = active();
    run_parallel(run_, static_cast<int>(count), [&](int i) {
      const auto k = static_cast<std::uint64_t>(i);
      const std::uint64_t goal = target / count + (k < target % count ? 1 : 0);
      active_[k]->advance(goal - active_[k]->steps());
    });
    steps_ = target;
  }

 private:
  void on_all_threads(const std::function<void(std::size_t)>& work) {
    run_parallel(run_, static_cast<int>(groups_.size()),
                 [&](int g) { work(static_cast<std::size_t>(g)); });
  }

  int max_vertices_;
  const Run& run_;
  std::vector<std::unique_ptr<Chains>> groups_;
  std::vector<Chains*> active_;
  bool is_started_ = false;
  std::uint64_t steps_ = 0;
};

}  // namespace wander
