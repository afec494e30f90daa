// The groups of chains of a run, at work: seeds, starts and steps, on all threads.  Of groups that
// have chains alone, and nothing that watches them, seeds and starts (lab/shown_chains.h).
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "mlt/run/chain_settings.h"
#include "mlt/run/group.h"
#include "mlt/run/large_film.h"
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
                                                 settings.chains_per_group, settings.film));
    const std::vector<int> film = space.scene().film_shape();
    if (Group<Chains> && settings.film.is_large(film))
      shared_.emplace(film, space.max_vertices(), settings.groups, settings.film);
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
    if constexpr (Group<Chains>) share_films();
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
    if (shared_) archive(*shared_);
  }

  // Steps of all chains together, shared evenly by the groups that take any.
  std::uint64_t steps() const { return steps_; }
  std::uint64_t active() const { return active_.size(); }
  void advance_to(std::uint64_t target) requires Group<Chains> {
    if (shared_) return advance_in_turns_to(target);
    const std::uint64_t count = active();
    run_parallel(run_, static_cast<int>(count), [&](int i) {
      const auto k = static_cast<std::uint64_t>(i);
      active_[k]->advance(goal_of(k, target) - active_[k]->steps());
    });
    steps_ = target;
  }

  // The pixels of a large film; none if every group has a film of its own.
  std::optional<SharedLight> shared_light() const {
    if (!shared_) return std::nullopt;
    if (steps_ == 0) return SharedLight{&*shared_, 0};
    const auto films = static_cast<double>(shared_->count());
    return SharedLight{&*shared_, mean_light_ * films / static_cast<double>(count()) *
                                      static_cast<double>(active()) / static_cast<double>(steps_)};
  }

 private:
  // Steps of the active group k when all have made so many.
  std::uint64_t goal_of(std::uint64_t k, std::uint64_t target) const {
    return target / active() + (k < target % active() ? 1 : 0);
  }

  // ---- large films
  //
  // Group g deposits b_g / b̄ times what it would on a film of its own, with b̄ the mean over all
  // groups, so that float holds numbers of the order of one whatever the unit of light.  A film then
  // estimates
  //   b̄ · (films / groups) · (Σ of deposits) / (steps of a group),
  // the mean of its groups.  They all have made the same number of steps, but for one: taking it for
  // their mean is wrong by less than one part in their number of steps.

  void share_films() {
    if (!shared_) return;
    mean_light_ = tally().mean();
    for (int g = 0; g < shared_->groups(); ++g) {
      Chains& group = *groups_[static_cast<std::size_t>(g)];
      group.share((*shared_)[shared_->film_of_group(g)],
                  shared_->share_of_group(g) * group.light_of_deposits() / mean_light_);
    }
  }

  // The groups of a film take turns in their order, on one thread.
  void advance_in_turns_to(std::uint64_t target) {
    std::vector<std::vector<std::uint64_t>> sharers(static_cast<std::size_t>(shared_->count()));
    std::uint64_t k = 0;
    for (int g = 0; g < shared_->groups(); ++g)
      if (groups_[static_cast<std::size_t>(g)]->takes_steps())
        sharers[static_cast<std::size_t>(shared_->film_of_group(g))].push_back(k++);
    while (steps_ < target) {
      const std::uint64_t turn = std::min(target - steps_, SharedFilms::steps_per_turn * active());
      run_parallel(run_, shared_->count(), [&](int film) {
        for (const std::uint64_t each : sharers[static_cast<std::size_t>(film)])
          active_[each]->advance(goal_of(each, steps_ + turn) - active_[each]->steps());
      });
      shared_->flush();
      steps_ += turn;
    }
  }

  void on_all_threads(const std::function<void(std::size_t)>& work) {
    run_parallel(run_, static_cast<int>(groups_.size()),
                 [&](int g) { work(static_cast<std::size_t>(g)); });
  }

  int max_vertices_;
  const Run& run_;
  std::vector<std::unique_ptr<Chains>> groups_;
  std::vector<Chains*> active_;
  std::optional<SharedFilms> shared_;
  double mean_light_ = 0;  // by the seed pass
  bool is_started_ = false;
  std::uint64_t steps_ = 0;
};

}  // namespace wander
