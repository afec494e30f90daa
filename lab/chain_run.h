// A run of chains: seed pass, starts and steps of all groups, and what is made of them.
//
// Groups of chains are the unit of parallel work; they share nothing, and are merged in their
// order.
#pragma once

#include <array>
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/vector.hpp>
#include <functional>
#include <memory>

#include "core/film_statistics.h"
#include "lab/live_run.h"
#include "mlt/run/chain_groups.h"
#include "mlt/run/large_film.h"
#include "mlt/run/normalization.h"
#include "mlt/run/normalized_film.h"
#include "mlt/run/path_group.h"
#include "mlt/run/warnings.h"
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
      : method_(method), space_(space), run_(run), settings_(settings) {
    make_ = [&space, kernel, &run](const ChainSettings& of) {
      return std::make_unique<ChainGroups<Space, Chains>>(space, kernel, run, of);
    };
    make_groups(settings.groups, settings.chains_per_group);
  }

  bool takes_seeds() const override { return !groups_->is_started(); }
  ChainSettings settings() const override { return settings_; }
  SeedPass seeds() const override {
    const SeedTally tally = groups_->tally();
    SeedPass pass{groups_->count(), tally.samples, tally.total.value() > 0};
    if (!pass.found_light) return pass;
    const Normalization b = normalization(tally);
    pass.relative_error = b.standard_error / b.value;
    return pass;
  }
  void seed(std::uint64_t of_each) override { groups_->add_seeds(of_each); }
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

  // With the constants of the seed pass.
  FilmEstimate preview() const override {
    Harvest harvest(space_, settings_.film);
    for (const auto& group : *groups_)
      group->deliver(harvest.film, harvest.statistics, harvest.draws);
    return unbiased_film(harvest.film);
  }

  Rendering findings() const override {
    Rendering r;
    Harvest harvest(space_, settings_.film);
    for (const auto& group : *groups_) {
      group->deliver(harvest.film, harvest.statistics, harvest.draws);
      r.chains += group->chains();
    }
    r.method = method_;
    r.samples = harvest.statistics.steps();
    r.groups = settings_.groups;
    run_within(run_, [&] {
      normalize(r, harvest.film);
      judge(r, groups_->tally(), harvest.draws, harvest.statistics);
    });
    return r;
  }

  void save(cereal::BinaryOutputArchive& archive) const override {
    const bool is_started = groups_->is_started();
    archive(settings_.groups, chains_made_, settings_.chains_per_group, is_started);
    groups_->serialize_seeds(archive);
    if (is_started) groups_->serialize_chains(archive);
  }
  void load(cereal::BinaryInputArchive& archive) override {
    int groups = 0, made = 0, chains = 0;
    bool is_started = false;
    archive(groups, made, chains, is_started);
    make_groups(groups, made);
    settings_.chains_per_group = chains;
    groups_->serialize_seeds(archive);
    if (!is_started) return;
    groups_->start(chains);  // makes again what follows from the seeds
    groups_->serialize_chains(archive);
  }

 private:
  static constexpr std::uint64_t steps_per_round = 1024;  // of each group

  // What the groups deliver.
  struct Harvest {
    Harvest(const Space& space, const FilmLayout& layout)
        : film(layout.raster(space.scene().resolution()).shape()),
          statistics(Chains::move_names(), layout.maps_of(space.scene().resolution()),
                     space.max_vertices()) {}
    GroupsFilm film;  // of a large film, its raster
    MutationStatistics statistics;
    ChainDraws draws{};
  };

  void make_groups(int groups, int chains_of_each) {
    settings_.groups = groups;
    settings_.chains_per_group = chains_made_ = chains_of_each;
    groups_ = make_(settings_);
  }

  void judge(Rendering& r, const SeedTally& tally, const ChainDraws& draws,
             const MutationStatistics& statistics) const {
    ChainsRecord chains;
    if (draws.chains() > 0) {
      chains = diagnostics(draws);
      chains.longest_rejection_run = statistics.longest_rejection_run();
      r.chains_record = chains;
    }
    r.mutations = statistics.records();
    for (std::string& warning : warnings({tally, draws, chains, statistics,
                                          static_cast<std::size_t>(settings_.chains_per_group)}))
      r.warnings.push_back(std::move(warning));
  }

  // ---- the film, of groups that each have their own, or of films that they share

  std::vector<int> shape() const {
    return {space_.scene().resolution().begin(), space_.scene().resolution().end()};
  }
  SharedLight shared_light() const {
    return {groups_->shared(), groups_->light_of_shared_deposit()};
  }
  FilmEstimate unbiased_film(const GroupsFilm& of_groups) const {
    if (!groups_->shared()) return of_groups.estimate();
    return mean_film(std::array{shared_light()}, shape());
  }
  FilmEstimate film_scaled_to(const Constant& b, std::span<const GroupFindings> findings) const {
    if (!groups_->shared()) return normalized_film(findings, b, shape());
    return normalized_film(std::array{shared_light()}, b, shape());
  }

  // `unbiased`: the mean of what each group says by its own slice of the seed pass.
  void normalize(Rendering& r, const GroupsFilm& unbiased) const {
    std::vector<GroupFindings> findings;
    for (const auto& group : *groups_) findings.push_back(group->findings());
    const Constants b = constants(findings);
    const NormalizationMethod method = b.usable(settings_.normalization);
    r.normalization = normalization(findings, b, settings_.normalization);
    r.film = method == NormalizationMethod::seed_pass ? unbiased_film(unbiased)
                                                      : film_scaled_to(b[method], findings);
    if (b[method].effective_samples < fewest_effective_samples)
      r.film.reliable.assign(r.film.reliable.size(), false);
    if (method != settings_.normalization)
      r.warnings.push_back("b is the mean of the seed pass, for the " +
                           std::string(name_of(settings_.normalization)) +
                           " estimate failed: " + b[settings_.normalization].failure);
    if (std::string alarm = disagreement_of_constants(findings, b); !alarm.empty())
      r.warnings.push_back(std::move(alarm));
  }

  const char* method_;
  const Space& space_;
  const Run& run_;
  ChainSettings settings_;  // chains_per_group: those that run
  int chains_made_ = 0;     // of each group, whether they run or not
  std::function<std::unique_ptr<ChainGroups<Space, Chains>>(const ChainSettings&)> make_;
  std::unique_ptr<ChainGroups<Space, Chains>> groups_;
};

}  // namespace wander
