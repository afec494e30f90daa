// The groups of chains of a run, at work: seeds, starts and steps, on all threads.  Of groups that
// have chains alone, and nothing that watches them, seeds and starts (lab/shown_chains.h).
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "mlt/run/chain_settings.h"
#include "mlt/run/group.h"
#include "mlt/run/large_film.h"
#include "work/parallel.h"

namespace wander {

// Of each group between two interrupts: `usual` steps or samples, or of long paths, of which each may cost the square
// of its vertices, as many as take no longer.  No clock has a part in it: films that are summed in parts show in their
// last bit where these end.
inline std::uint64_t turn_of(std::uint64_t usual, int max_vertices) {
  constexpr std::uint64_t vertices = 32;  // of a short path
  const std::uint64_t n = std::max(static_cast<std::uint64_t>(max_vertices), vertices);
  return std::max<std::uint64_t>(usual * vertices * vertices / (n * n), 1);
}

template <class C>
concept TakesSteps = ChainSource<C> && requires(C& chains, std::uint64_t count) {
  chains.advance(count);  // makes so many more steps, of all its chains together
  { chains.steps() } -> std::convertible_to<std::uint64_t>;
};

template <class Space, ChainSource Chains>
class ChainGroups {
 public:
  template <class Kernel>
  ChainGroups(const Space& space, const Kernel& kernel, const Run& run, std::uint64_t seed,
              const ChainSettings& settings)
      : max_vertices_(space.max_vertices()), run_(run) {
    for (int g = 0; g < settings.groups; ++g)
      groups_.push_back(std::make_unique<Chains>(space, kernel, seed, g, settings.chains_per_group,
                                                 settings.film));
    const std::vector<int> film = space.scene().film_shape();
    if (!Group<Chains> || !settings.film.is_large(film)) return;
    if (settings.film_parts == FilmParts::raster) return;
    shared_.emplace(film, space.max_vertices(), settings.groups, settings.film);
    if (settings.film_parts == FilmParts::chains) return;
    total_.emplace(values_of(film));
    samples_.emplace(film, space.max_vertices(), settings.film);
  }

  auto begin() const { return groups_.begin(); }
  auto end() const { return groups_.end(); }
  std::uint64_t count() const { return groups_.size(); }
  Chains& operator[](int group) const { return *groups_[static_cast<std::size_t>(group)]; }

  // Before the first sample: the film is pooled, and so many samples are made beside the chains.
  void pool(const Pooling& pooling) requires Group<Chains> {
    samples_per_step_ = pooling.samples_per_step;
    for (const auto& group : groups_) group->divide(pooling);
  }

  // The seed pass: so many more samples of each slice.
  void add_seeds(std::uint64_t count) {
    for (std::uint64_t done = 0; done < count;) {
      const std::uint64_t part = std::min(count - done, samples_ ? samples_per_turn : count);
      on_all_threads([&](std::size_t g) { groups_[g]->add_seeds(part); });
      if constexpr (Group<Chains>) gather_samples();
      done += part;
    }
  }
  std::uint64_t seed_stride() const {
    constexpr std::uint64_t usual = 256;
    return turn_of(usual, max_vertices_);
  }
  // Of all chains together.
  std::uint64_t step_stride() const {
    constexpr std::uint64_t usual = 1024;
    return turn_of(usual, max_vertices_) * active_;
  }
  SeedTally tally() const {
    SeedTally tally(max_vertices_);
    for (const auto& group : groups_) tally.merge(group->tally());
    return tally;
  }

  // After the seed pass; so many chains of each group.
  void start(int chains) {
    is_started_ = true;
    // All before any starts, for each reads what the others found.
    for (const auto& group : groups_) group->end_seeds();
    on_all_threads([&](std::size_t g) {
      SeedTally others(max_vertices_);
      for (std::size_t h = 0; h < groups_.size(); ++h)
        if (h != g) others.merge(groups_[h]->seed_tally());
      groups_[g]->keep_chains(chains);
      groups_[g]->start_chains(others);
    });
    place_.assign(groups_.size(), std::nullopt);
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (groups_[g]->takes_steps()) place_[g] = active_++;
    if constexpr (Group<Chains>) share_films();
  }

  bool is_started() const { return is_started_; }

  // The slices of the seed pass; and after start() from the same slices, what the steps have left.
  template <class Archive>
  void serialize_seeds(Archive& archive) {
    for (const auto& group : groups_) group->serialize_seeds(archive);
    if (samples_) archive(*samples_);
  }
  template <class Archive>
  void serialize_chains(Archive& archive) {
    archive(steps_);
    for (const auto& group : groups_) group->serialize_chains(archive);
    if (shared_) archive(*shared_);
    if (total_) archive(*total_);
  }

  // Steps of all chains together, shared evenly by the groups that take any.
  std::uint64_t steps() const { return steps_; }
  std::uint64_t active() const { return active_; }
  void advance_to(std::uint64_t target) requires TakesSteps<Chains> {
    if constexpr (Group<Chains>)
      if (shared_) return advance_in_turns_to(target);
    run_parallel(run_, static_cast<int>(count()), [&](int g) { advance_to(target, g); });
    steps_ = target;
  }

  // The pixels of a large film; none if every group has a film of its own.
  std::optional<SharedLight> shared_light() const {
    if (!shared_) return std::nullopt;
    SharedLight light{&*shared_, 0, 1, samples_ ? &*samples_ : nullptr,
                      total_ ? &*total_ : nullptr};
    if (steps_ == 0) return light;
    const auto films = static_cast<double>(shared_->count());
    light.scale = mean_light_ * films / static_cast<double>(count()) *
                  static_cast<double>(active()) / static_cast<double>(steps_);
    return light;
  }

 private:
  static constexpr std::uint64_t samples_per_turn = 256;  // of a large film, in lists until its end

  // Steps of the active group k when all have made so many.
  std::uint64_t goal_of(std::uint64_t k, std::uint64_t target) const {
    return target / active() + (k < target % active() ? 1 : 0);
  }
  // Samples of each group, whether its chains run or not, for what it found has no part in it.
  std::uint64_t samples_for(std::uint64_t target) const {
    const double wanted =
        samples_per_step_ * static_cast<double>(target) / static_cast<double>(count());
    return std::max(groups_.front()->seed_tally().samples, static_cast<std::uint64_t>(wanted));
  }

  // Of one group, steps and the samples beside them.
  void advance_to(std::uint64_t target, int g) {
    Chains& group = *groups_[static_cast<std::size_t>(g)];
    if (const auto k = place_[static_cast<std::size_t>(g)])
      group.advance(goal_of(*k, target) - group.steps());
    group.add_seeds(samples_for(target) - group.tally().samples);
  }
  // Those of a large film, in the order of the groups.
  void gather_samples() {
    if (!samples_) return;
    for (const auto& group : groups_) group->move_samples_to(*samples_);
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
    SeedTally seeds(max_vertices_);
    for (const auto& group : groups_) seeds.merge(group->seed_tally());
    mean_light_ = seeds.mean();
    for (int g = 0; g < shared_->groups(); ++g) {
      Chains& group = *groups_[static_cast<std::size_t>(g)];
      SharedFilm& film = (*shared_)[shared_->film_of_group(g)];
      const double factor = shared_->share_of_group(g) * group.light_of_deposits() / mean_light_;
      if (total_)
        group.share(film, *total_, factor);
      else
        group.share(film, factor);
    }
  }

  // No more than samples have room for in their lists.
  std::uint64_t steps_of_turn() const {
    const std::uint64_t most = SharedFilms::steps_per_turn * active();
    const double samples = static_cast<double>(samples_per_turn * count());
    if (!(samples_per_step_ * static_cast<double>(most) > samples)) return most;
    return std::max(active(), static_cast<std::uint64_t>(samples / samples_per_step_));
  }
  // The groups of a film take turns in their order, on one thread.
  void advance_in_turns_to(std::uint64_t target) {
    while (steps_ < target) {
      const std::uint64_t turn = std::min(target - steps_, steps_of_turn());
      run_parallel(run_, shared_->count(), [&](int film) {
        for (int g = film; g < shared_->groups(); g += shared_->count())
          advance_to(steps_ + turn, g);
      });
      shared_->flush();
      gather_samples();
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
  std::vector<std::optional<std::uint64_t>> place_;  // of each group among those that take steps,
  std::uint64_t active_ = 0;                         // so many
  double samples_per_step_ = 0;
  std::optional<SharedFilms> shared_;
  // Of a large film that is pooled: what the samples bring, and the film of the chains alone.
  std::optional<LargeSampleFilm> samples_;
  std::optional<TotalFilm> total_;
  double mean_light_ = 0;  // by the seed pass
  bool is_started_ = false;
  std::uint64_t steps_ = 0;
};

}  // namespace wander
