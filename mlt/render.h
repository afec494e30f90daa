// Metropolis light transport, in order.  Read this file first.
//
//   scene → seed pass → seeds and b → chains × mixture of mutations → steps → {film, statistics}
//
// Groups of chains are the unit of parallel work; they share nothing, and are merged in their
// order.
#pragma once

#include <memory>

#include "core/output/film_statistics.h"
#include "core/run.h"
#include "core/stopping_rule.h"
#include "mlt/chain_settings.h"
#include "mlt/group.h"
#include "mlt/normalization.h"
#include "mlt/normalized_film.h"
#include "mlt/path_group.h"
#include "mlt/warnings.h"

namespace wander {

// No sample of the seed pass found a path from a light to the sensor.
class NoLightFound : public std::runtime_error {
 public:
  explicit NoLightFound(std::uint64_t samples)
      : std::runtime_error(
            "the seed pass tried " + std::to_string(samples) +
            " bidirectional samples and found no light path from a light to the sensor, so no "
            "chain can start; look for walls without a gap, a light or sensor that faces away, or "
            "a max_vertices that is too small") {}
};

// `Chains` is a Group, made of a space and the kernel of its chains.
template <class Space, Group Chains>
class ChainRenderer {
 public:
  template <class Kernel>
  ChainRenderer(const Space& space, const Kernel& kernel, const Session& session,
                ChainSettings settings)
      : space_(space), session_(session), settings_(fitted(settings, session)), run_(session) {
    for (int g = 0; g < settings_.groups; ++g)
      groups_.push_back(
          std::make_unique<Chains>(space, kernel, session.seed, g, settings_.chains_per_group));
  }

  Rendering render(const char* method) {
    seed_pass();
    const double seed_seconds = run_.seconds();
    const SeedTally tally = merged_tally();
    if (!(tally.total.value() > 0)) throw NoLightFound(tally.samples);
    start_chains();
    if (const auto* budget = std::get_if<ErrorBudget>(&session_.budget))
      return run_to(budget->relative, method, tally, seed_seconds);
    const auto* budget = std::get_if<SampleBudget>(&session_.budget);
    run_chains(budget ? budget->samples : std::numeric_limits<std::uint64_t>::max());
    return rendering(method, tally, seed_seconds);
  }

 private:
  static constexpr std::uint64_t steps_per_round = 1024;  // of each group
  static constexpr std::uint64_t first_look = 1 << 17;    // steps, if the budget is an error
  static constexpr std::uint64_t seeds_per_round = 256;

  // A small budget makes fewer chains, so that it can be met exactly.
  static ChainSettings fitted(ChainSettings settings, const Session& session) {
    const auto* budget = std::get_if<SampleBudget>(&session.budget);
    if (!budget) return settings;
    const auto most = static_cast<int>(std::min<std::uint64_t>(budget->samples, 1 << 20));
    settings.chains_per_group = std::clamp(most / settings.groups, 1, settings.chains_per_group);
    settings.groups = std::min(settings.groups, most);
    return settings;
  }

  void in_parallel(const std::function<void(Chains&)>& work) {
    run_parallel(run_, settings_.groups,
                 [&](int g) { work(*groups_[static_cast<std::size_t>(g)]); });
  }

  // The error of the seed pass may be so much of the target, if that is the budget: then b takes
  // no more than a quarter of the variance.
  static constexpr double share_of_error = 0.5;

  void seed_pass() {
    if (const auto* budget = std::get_if<ErrorBudget>(&session_.budget))
      seed_pass_to(share_of_error * budget->relative);
    else
      seed_pass_of_budget();
  }

  // `per_group` more samples of each slice.
  void add_seeds(std::uint64_t per_group) {
    for (std::uint64_t done = 0; done < per_group && !run_.is_interrupted();) {
      const std::uint64_t count = std::min(seeds_per_round, per_group - done);
      in_parallel([&](Chains& group) { group.add_seeds(count); });
      run_.report({0, done += count, run_.seconds(), "seed pass"});
    }
  }
  void seed_pass_to(double target) {
    const auto groups = static_cast<std::uint64_t>(settings_.groups);
    add_seeds(settings_.fewest_seeds / groups);
    while (!run_.is_interrupted()) {
      const SeedTally tally = merged_tally();
      if (!(tally.total.value() > 0) && tally.samples >= samples_in_the_dark) return;
      const Normalization b = normalization(tally);
      const double error = b.standard_error / b.value;
      if (error <= target) return;
      add_seeds((next_look(tally.samples, error, target) - tally.samples) / groups + 1);
    }
  }

  // Every slice has the same number of samples.
  void seed_pass_of_budget() {
    const auto groups = static_cast<std::uint64_t>(settings_.groups);
    std::uint64_t per_group = std::numeric_limits<std::uint64_t>::max();
    double seconds = std::numeric_limits<double>::infinity();
    if (const auto* budget = std::get_if<SampleBudget>(&session_.budget)) {
      const double share = settings_.seed_share * static_cast<double>(budget->samples);
      per_group = std::max(settings_.fewest_seeds, static_cast<std::uint64_t>(share)) / groups;
    } else {
      seconds = settings_.seed_share / (1 + settings_.seed_share) *
                std::get<TimeBudget>(session_.budget).seconds;
    }
    for (std::uint64_t done = 0; done < per_group;) {
      const std::uint64_t count = std::min(seeds_per_round, per_group - done);
      in_parallel([&](Chains& group) { group.add_seeds(count); });
      done += count;
      const double fraction = std::max(static_cast<double>(done) / static_cast<double>(per_group),
                                       run_.seconds() / seconds);
      run_.report({fraction, done * groups, run_.seconds(), "seed pass"});
      if (fraction >= 1 || run_.is_interrupted()) break;
    }
  }

  void start_chains() {
    run_parallel(run_, settings_.groups, [&](int g) {
      SeedTally others(space_.max_vertices());
      for (int h = 0; h < settings_.groups; ++h)
        if (h != g) others.merge(groups_[static_cast<std::size_t>(h)]->tally());
      groups_[static_cast<std::size_t>(g)]->start_chains(others);
    });
  }

  SeedTally merged_tally() const {
    SeedTally tally(space_.max_vertices());
    for (const auto& group : groups_) tally.merge(group->tally());
    return tally;
  }

  Rendering run_to(double target, const char* method, const SeedTally& tally, double seed_seconds) {
    std::uint64_t goal = first_look;
    while (true) {
      run_chains(goal);
      Rendering r = rendering(method, tally, seed_seconds);
      const double error = relative_error(r.film);
      if (error <= target || run_.is_interrupted()) return r;
      fraction_of_error_ = std::min(1.0, target * target / (error * error));
      goal = next_look(goal, error, target);
    }
  }

  // The steps are shared evenly by the groups that take any.
  void run_chains(std::uint64_t target) {
    std::vector<Chains*> active;
    for (const auto& group : groups_)
      if (group->takes_steps()) active.push_back(group.get());
    const auto count = static_cast<std::uint64_t>(active.size());
    const auto* budget = std::get_if<TimeBudget>(&session_.budget);
    const double seconds = budget ? budget->seconds : std::numeric_limits<double>::infinity();
    std::uint64_t done = 0;
    for (const Chains* group : active) done += group->steps();
    while (done < target) {
      const std::uint64_t round = std::min(steps_per_round * count, target - done);
      run_parallel(run_, static_cast<int>(count), [&](int i) {
        const auto k = static_cast<std::uint64_t>(i);
        const std::uint64_t goal = (done + round) / count + (k < (done + round) % count ? 1 : 0);
        active[k]->advance(goal - active[k]->steps());
      });
      done += round;
      const double of_steps = static_cast<double>(done) / static_cast<double>(target);
      const double fraction = std::holds_alternative<ErrorBudget>(session_.budget)
                                  ? fraction_of_error_
                                  : std::max(of_steps, run_.seconds() / seconds);
      run_.report({fraction, done, run_.seconds(), "sampling"});
      if (run_.seconds() >= seconds || run_.is_interrupted()) break;
    }
  }

  Rendering rendering(const char* method, const SeedTally& tally, double seed_seconds) const {
    Rendering r;
    const auto resolution = space_.scene().resolution();
    GroupsFilm film({resolution.begin(), resolution.end()});
    MutationStatistics statistics(Chains::move_names(), space_.scene().bins(),
                                  space_.max_vertices());
    ChainDraws draws;
    for (const auto& group : groups_) {
      group->deliver(film, statistics, draws);
      r.chains += group->chains();
    }
    const auto* budget = std::get_if<SampleBudget>(&session_.budget);
    r.complete = budget ? statistics.steps() == budget->samples : !run_.is_interrupted();
    r.method = method;
    r.samples = statistics.steps();
    r.seed = session_.seed;
    r.threads = run_.threads();
    r.seconds = run_.seconds();
    r.seed_seconds = seed_seconds;
    normalize(r, film);
    r.groups = settings_.groups;
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
    return r;
  }

  // `unbiased`: the mean of what each group says by its own slice of the seed pass.
  void normalize(Rendering& r, const GroupsFilm& unbiased) const {
    std::vector<GroupFindings> findings;
    for (const auto& group : groups_) findings.push_back(group->findings());
    const Constants b = constants(findings);
    const NormalizationMethod method = b.usable(settings_.normalization);
    r.normalization = normalization(findings, b, settings_.normalization);
    r.film = method == NormalizationMethod::seed_pass
                 ? unbiased.estimate()
                 : normalized_film(findings, b[method], unbiased.resolution());
    if (b[method].effective_samples < fewest_effective_samples)
      r.film.reliable.assign(r.film.reliable.size(), false);
    if (method != settings_.normalization)
      r.warnings.push_back("b is the mean of the seed pass, for the " +
                           std::string(name_of(settings_.normalization)) +
                           " estimate failed: " + b[settings_.normalization].failure);
    if (std::string alarm = disagreement_of_constants(findings, b); !alarm.empty())
      r.warnings.push_back(std::move(alarm));
  }

  const Space& space_;
  const Session& session_;
  ChainSettings settings_;
  Run run_;
  double fraction_of_error_ = 0;  // of the way to the target, when last seen
  std::vector<std::unique_ptr<Chains>> groups_;
};

// Chains of a kernel in path space; other groups are named by the caller.
template <class Space, class Kernel>
ChainRenderer(const Space&, const Kernel&, const Session&, ChainSettings)
    -> ChainRenderer<Space, PathGroup<Space, Kernel>>;

}  // namespace wander
