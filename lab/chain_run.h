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

#include "lab/chain_findings.h"
#include "lab/live_run.h"
#include "mlt/run/chain_groups.h"
#include "mlt/run/large_film.h"
#include "mlt/run/normalization.h"
#include "mlt/run/path_group.h"
#include "mlt/run/pilot.h"
#include "mlt/seeds/nothing_found.h"
#include "work/parallel.h"

namespace wander {

// `Chains` is a Group, made of a space and the kernel of its chains.
template <class Space, Group Chains>
class ChainRun final : public LiveRun {
 public:
  template <class Kernel>
  ChainRun(const char* method, const Space& space, const Kernel& kernel, const Run& run,
           const ChainSettings& settings)
      : method_(method),
        space_(space),
        run_(run),
        settings_(settings),
        seed_share_(settings.seed_share.value_or(ChainSettings::usual_seed_share)) {
    make_ = [&space, kernel, &run](const ChainSettings& of, std::uint64_t seed) {
      return std::make_unique<ChainGroups<Space, Chains>>(space, kernel, run, seed, of);
    };
    make_groups(settings.groups, settings.chains_per_group);
  }

  bool takes_seeds() const override { return !groups_->is_started(); }
  ChainSettings settings() const override { return settings_; }
  void prepare() override {
    if (is_prepared()) return;
    const Pilot pilot = make_pilot();
    if (run_.is_interrupted()) return;
    const std::size_t bins = values_of(shape());
    pooling_ = settings_.seed_share ? pooling(pilot, *settings_.seed_share, bins)
                                    : best_pooling(pilot, bins);
    // Where samples go on beside the chains, seeds need no more than the fewest.
    if (!settings_.seed_share && is_telling(pilot)) seed_share_ = 0;
    groups_->pool(*pooling_);
  }
  double seed_share() const override { return seed_share_; }
  SeedPass seeds() const override {
    const SeedTally tally = groups_->tally();
    SeedPass pass{groups_->count(), tally.samples, tally.total.value() > 0};
    if (!pass.found_light) return pass;
    const Normalization b = normalization(tally);
    pass.relative_error = b.standard_error / b.value;
    return pass;
  }
  void seed(std::uint64_t of_each) override {
    prepare();
    if (is_prepared()) groups_->add_seeds(of_each);
  }
  void start(int chains) override {
    const SeedTally tally = groups_->tally();
    if (!(tally.total.value() > 0)) throw NoLightFound(tally.samples);
    settings_.chains_per_group = chains;
    groups_->start(chains);
  }

  void advance(std::uint64_t samples) override { groups_->advance_to(groups_->steps() + samples); }
  std::uint64_t samples() const override { return groups_->steps(); }
  std::uint64_t stride() const override { return steps_per_round * groups_->active(); }
  std::uint64_t first_look() const override { return 1 << 17; }

  // Of the chains alone, with the constants of the seed pass.
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
    dynamic_cast<ChainFindings&>(all).add(*groups_, settings_);
  }
  Rendering findings() const override {
    ChainFindings own(method_, shape(), no_statistics());
    own.add(*groups_, settings_);
    Rendering r;
    run_within(run_, [&] { r = own.rendering(); });
    return r;
  }

  void save(cereal::BinaryOutputArchive& archive) const override {
    const bool is_started = groups_->is_started();
    archive(settings_.groups, chains_made_, settings_.chains_per_group, is_started, pooling_,
            seed_share_);
    groups_->serialize_seeds(archive);
    if (is_started) groups_->serialize_chains(archive);
  }
  void load(cereal::BinaryInputArchive& archive) override {
    int groups = 0, made = 0, chains = 0;
    bool is_started = false;
    archive(groups, made, chains, is_started, pooling_, seed_share_);
    make_groups(groups, made);
    if (pooling_) groups_->pool(*pooling_);
    settings_.chains_per_group = chains;
    groups_->serialize_seeds(archive);
    if (!is_started) return;
    groups_->start(chains);  // makes again what follows from the seeds
    groups_->serialize_chains(archive);
  }

 private:
  static constexpr std::uint64_t steps_per_round = 1024;  // of each group

  // Of all groups together; few chains, so that they are long.
  static constexpr int chains_of_pilot = 16;
  static constexpr std::uint64_t pilot_samples = 1 << 13, most_pilot_samples = 1 << 15;
  std::uint64_t steps_of_pilot() const {
    constexpr double share = 1. / 32, steps_per_second = 1e6, fewest = 1 << 12, most = 1 << 18;
    double steps = most;
    if (const auto* budget = std::get_if<SampleBudget>(&run_.session().budget))
      steps = share * static_cast<double>(budget->samples);
    else if (const auto* budget = std::get_if<TimeBudget>(&run_.session().budget))
      steps = share * steps_per_second * budget->seconds;
    return static_cast<std::uint64_t>(std::clamp(steps, fewest, most));
  }
  Pilot make_pilot() const {
    ChainSettings settings = settings_;
    settings.groups = std::min(settings.groups, chains_of_pilot);
    settings.chains_per_group = 1;
    settings.film_parts = FilmParts::raster;
    const auto trial = make_(settings, seed_of_pilot(run_.session().seed));
    Pilot pilot;
    for (std::uint64_t count = pilot_samples; count <= most_pilot_samples; count *= 2) {
      trial->add_seeds(count / trial->count() + 1 - (*trial)[0].tally().samples);
      pilot = found_by(*trial, 0);
      if (is_telling(pilot) || run_.is_interrupted()) break;
    }
    if (!is_telling(pilot) || run_.is_interrupted()) return pilot;
    for (const double c : borders_around(pilot.b())) trial->pool({.partition = {c}});
    trial->start(1);
    trial->advance_to(steps_of_pilot());
    return found_by(*trial, trial->steps() / trial->active());
  }
  static Pilot found_by(const ChainGroups<Space, Chains>& groups, std::uint64_t steps) {
    std::vector<GroupFindings> found;
    double rays = 0;
    for (const auto& group : groups) {
      found.push_back(group->findings());
      rays += static_cast<double>(group->rays());
    }
    return pilot_of(found, rays, steps);
  }

  bool is_prepared() const { return settings_.film_parts == FilmParts::chains || pooling_; }
  std::vector<int> shape() const { return space_.scene().film_shape(); }
  MutationStatistics no_statistics() const {
    return {Chains::move_names(), settings_.film.maps_of(space_.scene().resolution()),
            space_.max_vertices()};
  }

  void make_groups(int groups, int chains_of_each) {
    settings_.groups = groups;
    settings_.chains_per_group = chains_made_ = chains_of_each;
    groups_ = make_(settings_, run_.session().seed);
  }

  const char* method_;
  const Space& space_;
  const Run& run_;
  ChainSettings settings_;          // chains_per_group: those that run
  int chains_made_ = 0;             // of each group, whether they run or not
  double seed_share_;               // of the seed pass before the chains
  std::optional<Pooling> pooling_;  // once the pilot has run
  std::function<std::unique_ptr<ChainGroups<Space, Chains>>(const ChainSettings&,
                                                            std::uint64_t seed)>
      make_;
  std::unique_ptr<ChainGroups<Space, Chains>> groups_;
};

}  // namespace wander
