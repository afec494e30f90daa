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
#include "mlt/run/chain_groups.h"
#include "mlt/run/large_film.h"
#include "mlt/run/normalization.h"
#include "mlt/run/path_group.h"
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
    make_ = [&space, kernel, &run](const ChainSettings& of, std::uint64_t seed, double) {
      return std::make_unique<Groups>(space, kernel, run, seed, of);
    };
    make_trial_ = [this, kernel](std::uint64_t seed, double) {
      return std::make_unique<Trial>(space_, kernel, run_, seed, settings_of_trial());
    };
    make_groups(settings.groups, settings.chains_per_group);
  }
  template <class KernelOf>
  ChainRun(const char* method, const Space& space, const Adaptable<KernelOf>& kernel,
           const Run& run, const ChainSettings& settings)
      : ChainRun(method, space, run, settings) {
    is_adapted_ = false;
    make_ = [&space, kernel, &run](const ChainSettings& of, std::uint64_t seed, double factor) {
      return std::make_unique<Groups>(space, kernel.scaled(factor), run, seed, of);
    };
    make_trial_ = [this, kernel](std::uint64_t seed, double factor) {
      return std::make_unique<Trial>(space_, kernel.scaled(factor), run_, seed,
                                     settings_of_trial());
    };
    make_groups(settings.groups, settings.chains_per_group);
  }

  bool takes_seeds() const override { return !groups_->is_started(); }
  ChainSettings settings() const override {
    ChainSettings now = settings_;
    now.fewest_seeds = std::max(now.fewest_seeds, seeds_for_groups_);
    return now;
  }
  void prepare() override {
    if (is_prepared() || run_.is_interrupted()) return;
    if (settings_.film_parts == FilmParts::chains) return adapt();
    const auto make = [this](double kernel) {
      return make_trial_(seed_of_pilot(run_.session().seed), kernel);
    };
    PilotRun pilot(make, kernel(), space_.scene().resolution(), run_);
    const auto of_easy_light = this->of_easy_light(pilot.samples());
    if (run_.is_interrupted()) return;
    if (of_easy_light) {
      keep_usual_kernel();
      return pool(pilot.samples(), *of_easy_light);
    }
    adapt();
    const Pilot found = with_steps_per_seed(pilot.with_chains(kernel(), steps_per_chain()));
    if (run_.is_interrupted()) return;
    pool(found, settings_.seed_share ? with_seed_share(found, *settings_.seed_share)
                                     : best_pooling(found, bins(), most_cost()));
  }
  double seed_share() const override { return seed_share_; }
  SeedPass seeds() const override {
    const SeedTally tally = groups_->tally();
    SeedPass pass{groups_->count(), tally.samples, tally.rays, tally.total.value() > 0};
    if (!pass.found_light) return pass;
    const Normalization b = normalization(tally);
    pass.relative_error = b.standard_error / b.value;
    return pass;
  }
  void seed(std::uint64_t of_each) override {
    prepare();
    if (is_prepared()) groups_->add_seeds(of_each);
  }
  std::uint64_t seed_stride() const override { return groups_->seed_stride(); }
  void start(int chains) override {
    const SeedTally tally = groups_->tally();
    if (!(tally.total.value() > 0)) throw NoLightFound(tally.samples);
    settings_.chains_per_group = chains;
    groups_->start(chains);
  }

  void advance(std::uint64_t samples) override { groups_->advance_to(groups_->steps() + samples); }
  std::uint64_t samples() const override { return groups_->steps(); }
  // An interrupt is heard between two, and a step costs its vertices.
  std::uint64_t stride() const override {
    constexpr std::uint64_t usual = 1024;  // steps of each group
    const auto n = static_cast<std::uint64_t>(space_.max_vertices());
    return usual * short_paths / std::max(n, short_paths) * groups_->active();
  }
  std::uint64_t first_look() const override { return 1 << 17; }

  // Of the chains alone with the constants of the seed pass; or pooled, as it comes out.
  FilmEstimate preview() const override {
    if (pooling_) return findings().film;
    if (const auto shared = groups_->shared_light()) return mean_film(*shared, shape());
    GroupsFilm film(shape());
    MutationStatistics statistics = no_statistics();
    ChainDraws draws;
    for (const auto& group : *groups_) group->deliver(film, statistics, draws);
    return film.estimate();
  }

  std::unique_ptr<Findings> no_findings() const override {
    return std::make_unique<ChainFindings>(method_, shape(), no_statistics());
  }
  void add_to(Findings& all) const override {
    dynamic_cast<ChainFindings&>(all).add(*groups_, settings_, adaptation_);
  }
  Rendering findings() const override {
    ChainFindings own(method_, shape(), no_statistics());
    add_to(own);
    Rendering r;
    run_within(run_, [&] { r = own.rendering(); });
    return r;
  }

  void save(cereal::BinaryOutputArchive& archive) const override {
    const bool is_started = groups_->is_started();
    archive(settings_.groups, chains_made_, settings_.chains_per_group, is_started, is_adapted_,
            adaptation_, pooling_, seed_share_, seeds_for_groups_);
    groups_->serialize_seeds(archive);
    if (is_started) groups_->serialize_chains(archive);
  }
  void load(cereal::BinaryInputArchive& archive) override {
    int groups = 0, made = 0, chains = 0;
    bool is_started = false;
    archive(groups, made, chains, is_started, is_adapted_, adaptation_, pooling_, seed_share_,
            seeds_for_groups_);
    make_groups(groups, made);
    if (pooling_) groups_->pool(*pooling_);
    settings_.chains_per_group = chains;
    groups_->serialize_seeds(archive);
    if (!is_started) return;
    groups_->start(chains);  // makes again what follows from the seeds
    groups_->serialize_chains(archive);
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

  // Of the run, as far as it is known before it; of an error it is not.
  double steps() const {
    const auto most = static_cast<double>(settings_.steps_per_chain);
    return expected_steps(run_).value_or(most * settings_.groups * settings_.chains_per_group);
  }
  double steps_per_chain() const {
    const double all = steps();
    return all / (settings_.groups * settings_.chains_for(static_cast<std::uint64_t>(all)));
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
    make_groups(settings_.groups, settings_.chains_per_group);
  }
  void keep_usual_kernel() {
    if (!is_adapted_) adaptation_.emplace();
    is_adapted_ = true;
  }
  double kernel() const { return adaptation_ ? adaptation_->kernel : Adaptation{}.kernel; }
  std::optional<Pooling> of_easy_light(const Pilot& samples) const {
    if (settings_.seed_share) return {};
    return pooling_of_easy_light(samples, bins(), most_cost());
  }
  Pilot with_steps_per_seed(Pilot pilot) const {
    if (is_telling(pilot))
      pilot.steps_per_seed =
          steps() / static_cast<double>(std::max(settings_.fewest_seeds, seeds_for(pilot)));
    return pilot;
  }
  void pool(const Pilot& pilot, const Pooling& pooling) {
    pooling_ = pooling;
    // Where samples go on beside the chains, seeds need no more than the fewest, or what it takes for
    // the slice of a group to find light.
    if (!settings_.seed_share && is_telling(pilot)) {
      seed_share_ = 0;
      seeds_for_groups_ = seeds_for(pilot);
    }
    if (!settings_.seed_share && finds_rare_light(pilot)) seed_share_ = seed_share_of_rare_light();
    groups_->pool(pooling);
  }
  double seed_share_of_rare_light() const {
    const bool is_of_time = std::holds_alternative<TimeBudget>(run_.session().budget);
    return is_of_time ? ChainSettings::seed_share_of_rare_light : samples_per_step_of_rare_light;
  }
  double most_cost() const {
    const bool is_of_steps = std::holds_alternative<SampleBudget>(run_.session().budget);
    return is_of_steps ? most_cost_of_given_steps : usual_most_cost;
  }
  // All samples before the chains: of a budget of time the share is one of seconds.
  Pooling with_seed_share(Pilot pilot, double share) const {
    const bool is_of_time = std::holds_alternative<TimeBudget>(run_.session().budget);
    const double cost = pooling(pilot, share, bins()).cost_of_sample;
    const double samples_per_step = is_of_time && cost > 0 ? share / cost : share;
    pilot.steps_per_seed = 1 / samples_per_step;
    Pooling all_before = pooling(pilot, samples_per_step, bins());
    all_before.samples_per_step = 0;
    return all_before;
  }
  // So that the slice of a group carries so many effective samples; no more than the usual share.
  std::uint64_t seeds_for(const Pilot& pilot) const {
    constexpr double effective_samples_of_slice = 16;
    double seeds =
        effective_samples_of_slice * settings_.groups * pilot.samples / pilot.effective_samples();
    if (const auto* budget = std::get_if<SampleBudget>(&run_.session().budget))
      seeds =
          std::min(seeds, ChainSettings::usual_seed_share * static_cast<double>(budget->samples));
    return static_cast<std::uint64_t>(std::min(seeds, 1e9));
  }

  bool is_prepared() const {
    return is_adapted_ && (settings_.film_parts == FilmParts::chains || pooling_);
  }
  std::size_t bins() const { return values_of(shape()); }
  std::vector<int> shape() const { return space_.scene().film_shape(); }
  MutationStatistics no_statistics() const {
    return {Chains::move_names(), settings_.film.maps_of(space_.scene().resolution()),
            space_.max_vertices()};
  }

  void make_groups(int groups, int chains_of_each) {
    settings_.groups = groups;
    settings_.chains_per_group = chains_made_ = chains_of_each;
    groups_.reset();  // not the memory of both
    groups_ = make_(settings_, run_.session().seed, kernel());
  }

  const char* method_;
  const Space& space_;
  const Run& run_;
  ChainSettings settings_;                // chains_per_group: those that run
  int chains_made_ = 0;                   // of each group, whether they run or not
  std::uint64_t seeds_for_groups_ = 0;    // by the pilot
  double seed_share_;                     // of the seed pass before the chains
  bool is_adapted_ = true;                // or the kernel is given
  std::optional<Adaptation> adaptation_;  // if it was
  std::optional<Pooling> pooling_;        // once the pilot has run
  std::function<std::unique_ptr<Groups>(const ChainSettings&, std::uint64_t seed, double kernel)>
      make_;
  std::function<std::unique_ptr<Trial>(std::uint64_t seed, double kernel)> make_trial_;
  std::unique_ptr<Groups> groups_;
};

}  // namespace wander
