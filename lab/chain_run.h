// A run of chains: seed pass, starts and steps of all groups.  What is made of them is in
// chain_findings.h.
//
// Groups of chains are the unit of parallel work; they share nothing, and are merged in their
// order.
#pragma once

#include <algorithm>
#include <array>
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/vector.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <variant>

#include "lab/adaptation_run.h"
#include "lab/archived_sums.h"
#include "lab/chain_findings.h"
#include "lab/live_run.h"
#include "lab/pilot_run.h"
#include "lab/pooling_plan.h"
#include "mlt/run/chain_groups.h"
#include "mlt/run/large_film.h"
#include "mlt/run/normalization.h"
#include "mlt/run/path_group.h"
#include "mlt/run/test_image.h"
#include "mlt/run/trial_group.h"
#include "mlt/seeds/nothing_found.h"
#include "work/parallel.h"

namespace wander {

// A kernel that is yet to be adapted: scaled(factor) is the one whose small moves go so many times as
// far as usual.
template <class KernelOf>
struct Adaptable {
  KernelOf scaled;
};

// `Chains` is a Group, made of a space and the kernel of its chains.
template <class Space, Group Chains>
class ChainRun final : public LiveRun {
 public:
  template <class Kernel>
  ChainRun(const char* method, const Space& space, const Kernel& kernel, const Run& run,
           const ChainSettings& settings)
      : ChainRun(method, space, run, settings) {
    make_ = [this, kernel](const ChainSettings& of, std::uint64_t seed, double) {
      return std::make_unique<Groups>(space_, kernel, run_, seed, of);
    };
    make_trial_ = [this, kernel](std::uint64_t seed, double) {
      return std::make_unique<Trial>(space_, kernel, run_, seed, settings_of_trial());
    };
    renew_groups(settings.groups, settings.chains_per_group);
  }
  template <class KernelOf>
  ChainRun(const char* method, const Space& space, const Adaptable<KernelOf>& kernel,
           const Run& run, const ChainSettings& settings)
      : ChainRun(method, space, run, settings) {
    is_adapted_ = false;
    make_ = [this, kernel](const ChainSettings& of, std::uint64_t seed, double factor) {
      return std::make_unique<Groups>(space_, kernel.scaled(factor), run_, seed, of);
    };
    make_trial_ = [this, kernel](std::uint64_t seed, double factor) {
      return std::make_unique<Trial>(space_, kernel.scaled(factor), run_, seed,
                                     settings_of_trial());
    };
    renew_groups(settings.groups, settings.chains_per_group);
  }

  bool takes_seeds() const override { return !groups_ || !groups_->is_started(); }
  ChainSettings settings() const override { return settings_; }
  void prepare() override {
    if (is_prepared() || run_.is_interrupted()) return;
    choose_target([this] { return run_.is_interrupted(); });
    if (run_.is_interrupted()) return;
    if (settings_.film_parts == FilmParts::chains) return adapt();
    const auto make = [this](double kernel) {
      return make_trial_(seed_of_pilot(run_.session().seed), kernel);
    };
    PilotRun pilot(make, kernel(), space_.scene().resolution(), run_);
    const PoolingPlanner planner(run_, settings_, planned_film());
    const auto of_easy_light = planner.by_samples(pilot.samples());
    if (run_.is_interrupted()) return;
    if (of_easy_light) {
      keep_usual_kernel();
      return pool(*of_easy_light);
    }
    adapt();
    if (run_.is_interrupted()) return;
    const Pilot found =
        pilot.with_chains(kernel(), planner.steps_per_chain(),
                          [&](const Pilot& early) { return planner.leaves_to_samples(early); });
    if (!run_.is_interrupted()) pool(planner.by_chains(found));
  }
  double seed_share() const override { return seed_share_; }
  SeedPass seeds() const override {
    const SeedTally tally = groups().tally();
    SeedPass pass{groups().count(), tally.samples, tally.rays, tally.total.value() > 0};
    if (!pass.found_light) return pass;
    const Normalization b = normalization(tally);
    pass.relative_error = b.standard_error / b.value;
    return pass;
  }
  void seed(std::uint64_t of_each) override {
    prepare();
    if (is_prepared()) groups().add_seeds(of_each);
  }
  std::uint64_t seed_stride() const override { return groups().seed_stride(); }
  void start(int chains) override {
    const SeedTally tally = groups().tally();
    if (!(tally.total.value() > 0)) throw NoLightFound(tally.samples);
    settings_.chains_per_group = chains;
    groups().start(chains);
  }

  void advance(std::uint64_t samples) override { groups().advance_to(groups().steps() + samples); }
  std::uint64_t samples() const override { return groups_ ? groups_->steps() : 0; }
  std::uint64_t stride() const override { return groups().step_stride(); }
  // As dear as it is of chains alone where samples go on beside each step, for they tell the error.
  std::uint64_t first_look() const override {
    constexpr double usual = 1 << 17, fewest = 1 << 12;
    const double samples = pooling_ ? pooling_->samples_per_step : 0;
    return static_cast<std::uint64_t>(std::max(fewest, usual / (1 + samples)));
  }
  bool lacks_samples(double error) const override {
    return pooling_ ? !(pooling_->samples_per_step > 0) : seeds().relative_error > error;
  }

  // Of the chains alone with the constants of the seed pass; or pooled, as it comes out.
  FilmEstimate preview() const override {
    if (pooling_) return findings().film;
    if (const auto shared = groups().shared_light()) return mean_film(*shared, shape());
    GroupsFilm film(shape());
    MutationStatistics statistics = no_statistics();
    ChainDraws draws;
    for (const auto& group : groups()) group->deliver(film, statistics, draws);
    return film.estimate();
  }

  std::unique_ptr<Findings> no_findings() const override {
    return std::make_unique<ChainFindings>(method_, shape(), no_statistics(), must_meet());
  }
  void add_to(Findings& all) const override {
    dynamic_cast<ChainFindings&>(all).add(groups(), settings_, adaptation_);
  }
  Rendering findings() const override {
    ChainFindings own(method_, shape(), no_statistics(), must_meet());
    add_to(own);
    Rendering r;
    run_within(run_, [&] { r = own.rendering(); });
    return r;
  }

  // Each bin of each film that groups share is asked for its error (large_pooled_film.h).
  double seconds_of_findings() const override {
    constexpr double of_each = 6e-9;
    if (!settings_.film.is_large(shape())) return 0;
    const int films = SharedFilms::films_of(shape(), settings_.groups, settings_.film);
    return of_each * films * static_cast<double>(bins());
  }

  void save(cereal::BinaryOutputArchive& archive) const override {
    const bool is_started = groups().is_started();
    archive(settings_.groups, chains_made_, settings_.chains_per_group, settings_.steps_per_chain,
            settings_.fewest_seeds, is_started, is_adapted_, adaptation_, pooling_, seed_share_);
    groups().serialize_seeds(archive);
    if (is_started) groups().serialize_chains(archive);
  }
  void make_room() override { groups(); }
  void load(cereal::BinaryInputArchive& archive) override {
    int count = 0, made = 0, chains = 0;
    bool is_started = false;
    archive(count, made, chains, settings_.steps_per_chain, settings_.fewest_seeds, is_started,
            is_adapted_, adaptation_, pooling_, seed_share_);
    choose_target([] { return false; });
    renew_groups(count, made);
    if (pooling_) groups().pool(*pooling_);
    settings_.chains_per_group = chains;
    groups().serialize_seeds(archive);
    if (!is_started) return;
    groups().start(chains);  // makes again what follows from the seeds
    groups().serialize_chains(archive);
  }

 private:
  using Groups = ChainGroups<Space, Chains>;
  using Trial = ChainGroups<Space, TrialGroup<typename Chains::Source>>;

  ChainRun(const char* method, const Space& space, const Run& run, const ChainSettings& settings)
      : method_(method),
        space_(space),
        run_(run),
        settings_(settings),
        seed_share_(settings.seed_share.value_or(ChainSettings::usual_seed_share)) {}

  // From then on the space measures by it.  It is the same whenever it is made.
  template <class Interrupted>
  void choose_target(Interrupted&& is_interrupted) {
    if constexpr (Chains::Source::may_have_even_target) {
      if (settings_.target != Target::even || importance_) return;
      importance_ = importance_of_test_image(space_, is_interrupted);
      if (!importance_) return;
      space_ = space_.measuring(*importance_);
      renew_groups(settings_.groups, settings_.chains_per_group);
    }
  }
  // Of a pilot, or of an adaptation.
  ChainSettings settings_of_trial() const {
    ChainSettings settings = settings_;
    settings.groups = std::min(settings.groups, chains_of_pilot);
    settings.chains_per_group = 1;
    settings.film_parts = FilmParts::raster;
    constexpr std::size_t bins = 1 << 10;  // τ asks for no more, and there may be many films
    settings.film = {.most_small = bins};
    return settings;
  }
  // Before the first sample: how far small moves go, if that was left to be found.
  void adapt() {
    if (is_adapted_) return;
    const auto make = [&](double factor) {
      return make_(settings_of_trial(), seed_of_adaptation(run_.session().seed), factor);
    };
    const Adaptation found = AdaptationRun(make, settings_.film_parts, bins(), run_).run();
    if (run_.is_interrupted()) return;
    is_adapted_ = true;
    adaptation_ = found;
    renew_groups(settings_.groups, settings_.chains_per_group);
  }
  void keep_usual_kernel() {
    if (!is_adapted_) adaptation_.emplace();
    is_adapted_ = true;
  }
  double kernel() const { return adaptation_ ? adaptation_->kernel : Adaptation{}.kernel; }
  void pool(const PoolingPlan& plan) {
    pooling_ = plan.pooling;
    seed_share_ = plan.seed_share;
    settings_ = plan.settings;
    if (settings_.chains_per_group != chains_made_)
      renew_groups(settings_.groups, settings_.chains_per_group);
    groups().pool(*pooling_);
  }

  bool is_prepared() const {
    return is_adapted_ && (settings_.film_parts == FilmParts::chains || pooling_);
  }
  std::size_t bins() const { return values_of(shape()); }
  PlannedFilm planned_film() const {
    const bool is_image = space_.scene().resolution().size() > 1;
    return {is_image ? FilmKind::image : FilmKind::curve, bins(), space_.max_vertices()};
  }
  std::vector<int> shape() const { return space_.scene().film_shape(); }
  MutationStatistics no_statistics() const {
    return {Chains::move_names(), settings_.film.maps_of(space_.scene().resolution()),
            space_.max_vertices()};
  }

  FoundByChance must_meet() const { return found_by_chance(space_.scene(), MetByChance::either); }

  // From then on, when next they are asked for, there are so many.
  void renew_groups(int groups, int chains_of_each) {
    settings_.groups = groups;
    settings_.chains_per_group = chains_made_ = chains_of_each;
    groups_.reset();
  }
  // They take memory, and what a pilot and an adaptation decide makes them anew.
  Groups& groups() const {
    if (groups_) return *groups_;
    ChainSettings settings = settings_;
    settings.chains_per_group = chains_made_;
    groups_ = make_(settings, run_.session().seed, kernel());
    return *groups_;
  }

  const char* method_;
  std::optional<ImportanceMap> importance_;  // of an even target
  Space space_;                              // measures by it
  const Run& run_;
  ChainSettings settings_;  // once the pilot has run, as it says; of chains, those that run
  int chains_made_ = 0;     // of each group, whether they run or not
  double seed_share_;       // of the seed pass before the chains
  bool is_adapted_ = true;  // or the kernel is given
  std::optional<Adaptation> adaptation_;  // if it was
  std::optional<Pooling> pooling_;        // once the pilot has run
  std::function<std::unique_ptr<Groups>(const ChainSettings&, std::uint64_t seed, double kernel)>
      make_;
  std::function<std::unique_ptr<Trial>(std::uint64_t seed, double kernel)> make_trial_;
  mutable std::unique_ptr<Groups> groups_;  // none until one asks
};

}  // namespace wander
