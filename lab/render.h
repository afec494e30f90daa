// Metropolis light transport, in order.  Read this file first.
//
//   scene → seed pass → seeds and b → chains × mixture of mutations → steps → {film, statistics}
//
// Groups of chains are the unit of parallel work; they share nothing, and are merged in their
// order.
#pragma once

#include <utility>

#include "core/film_statistics.h"
#include "mlt/run/chain_groups.h"
#include "mlt/run/normalization.h"
#include "mlt/run/normalized_film.h"
#include "mlt/run/path_group.h"
#include "mlt/run/warnings.h"
#include "mlt/seeds/nothing_found.h"
#include "records/rendering.h"
#include "work/pace.h"
#include "work/parallel.h"
#include "work/stopping_rule.h"

namespace wander {

// `Chains` is a Group, made of a space and the kernel of its chains.
template <class Space, Group Chains>
class ChainRenderer {
 public:
  template <class Kernel>
  ChainRenderer(const Space& space, const Kernel& kernel, const Session& session,
                ChainSettings settings)
      : space_(space),
        session_(session),
        settings_(fitted(settings, session)),
        run_(session),
        groups_(space, kernel, run_, settings_) {}

  Rendering render(const char* method) {
    seed_pass();
    const double seed_seconds = run_.seconds();
    const SeedTally tally = groups_.tally();
    if (!(tally.total.value() > 0)) throw NoLightFound(tally.samples);
    settings_.chains_per_group = chains_for(expected_steps(tally.samples));
    groups_.start(settings_.chains_per_group);
    if (const auto* budget = std::get_if<ErrorBudget>(&session_.budget))
      return run_to(budget->relative, method, tally, seed_seconds);
    if (const auto* budget = std::get_if<TimeBudget>(&session_.budget))
      run_chains_until(budget->seconds, [&] { rendering(method, tally, seed_seconds); });
    else
      run_chains(std::get<SampleBudget>(session_.budget).samples);
    return rendering(method, tally, seed_seconds);
  }

 private:
  static constexpr std::uint64_t steps_per_round = 1024;  // of each group
  static constexpr std::uint64_t first_look = 1 << 17;    // steps, if the budget is an error
  static constexpr std::uint64_t seeds_per_round = 256;
  static constexpr double rehearsed_after = 0.25;  // of the time of the chains

  // A small budget makes fewer chains, so that it can be met exactly.
  static ChainSettings fitted(ChainSettings settings, const Session& session) {
    const auto* budget = std::get_if<SampleBudget>(&session.budget);
    if (!budget) return settings;
    const auto most = static_cast<int>(std::min<std::uint64_t>(budget->samples, 1 << 20));
    settings.chains_per_group = std::clamp(most / settings.groups, 1, settings.chains_per_group);
    settings.groups = std::min(settings.groups, most);
    return settings;
  }

  // The error of the seed pass may be so much of the target, if that is the budget: then b takes
  // no more than a quarter of the variance.
  static constexpr double share_of_error = 0.5;

  void seed_pass() {
    if (const auto* budget = std::get_if<ErrorBudget>(&session_.budget))
      seed_pass_to(share_of_error * budget->relative);
    else if (const auto* time = std::get_if<TimeBudget>(&session_.budget))
      seed_pass_until(settings_.seed_share / (1 + settings_.seed_share) * time->seconds);
    else
      seed_pass_of(std::get<SampleBudget>(session_.budget).samples);
  }

  // `per_group` more samples of each slice; `fraction` of the budget is done after so many of them.
  template <class Fraction>
  void add_seeds(std::uint64_t per_group, Fraction&& fraction) {
    for (std::uint64_t done = 0; done < per_group && !run_.is_interrupted();) {
      const std::uint64_t count = std::min(seeds_per_round, per_group - done);
      groups_.add_seeds(count);
      done += count;
      report(fraction(done), done * groups_.count(), "seed pass");
    }
  }
  void seed_pass_to(double target) {
    const auto unknown = [](std::uint64_t) { return 0.0; };
    add_seeds(settings_.fewest_seeds / groups_.count(), unknown);
    while (!run_.is_interrupted()) {
      const SeedTally tally = groups_.tally();
      if (!(tally.total.value() > 0) && tally.samples >= samples_in_the_dark) return;
      const Normalization b = normalization(tally);
      const double error = b.standard_error / b.value;
      if (error <= target) return;
      add_seeds((next_look(tally.samples, error, target) - tally.samples) / groups_.count() + 1,
                unknown);
    }
  }

  // Every slice has the same number of samples.
  void seed_pass_of(std::uint64_t steps) {
    const double share = settings_.seed_share * static_cast<double>(steps);
    const std::uint64_t per_group =
        std::max(settings_.fewest_seeds, static_cast<std::uint64_t>(share)) / groups_.count();
    add_seeds(per_group, [per_group](std::uint64_t done) {
      return static_cast<double>(done) / static_cast<double>(per_group);
    });
  }
  void seed_pass_until(double seconds) {
    const std::uint64_t groups = groups_.count();
    Pace pace(run_.spent(), seconds, seeds_per_round * groups);
    std::uint64_t done = 0;
    for (double now = run_.spent(); done == 0 || !pace.is_over(now); now = run_.spent()) {
      const std::uint64_t count = pace.next(now, done) / groups + 1;
      groups_.add_seeds(count);
      done += count * groups;
      report(now / std::get<TimeBudget>(session_.budget).seconds, done, "seed pass");
      if (run_.is_interrupted()) return;
    }
  }

  // In a time budget a step is taken to cost as much as a sample of the seed pass, which is too
  // much for most; how many steps an error takes is not known, so none are expected.
  std::uint64_t expected_steps(std::uint64_t seeds) const {
    if (const auto* budget = std::get_if<SampleBudget>(&session_.budget)) return budget->samples;
    const auto* budget = std::get_if<TimeBudget>(&session_.budget);
    if (!budget) return 0;
    const double now = run_.spent();
    return static_cast<std::uint64_t>(static_cast<double>(seeds) *
                                      std::max(0.0, budget->seconds - now) / std::max(now, 1e-9));
  }
  // Of each group.
  int chains_for(std::uint64_t steps) const {
    if (settings_.steps_per_chain == 0) return settings_.chains_per_group;
    const auto most = static_cast<std::uint64_t>(settings_.chains_per_group);
    const std::uint64_t enough = steps / settings_.steps_per_chain / groups_.count();
    return static_cast<int>(std::clamp<std::uint64_t>(enough, 1, most));
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

  void run_chains(std::uint64_t target) {
    while (groups_.steps() < target) {
      const std::uint64_t next = groups_.steps() + steps_per_round * groups_.active();
      groups_.advance_to(std::min(next, target));
      const auto done = static_cast<double>(groups_.steps());
      report(std::holds_alternative<ErrorBudget>(session_.budget)
                 ? fraction_of_error_
                 : done / static_cast<double>(target),
             groups_.steps(), "sampling");
      if (run_.is_interrupted()) return;
    }
  }

  // end() does what comes after the steps: it is rehearsed once, so that its time is known.
  template <class End>
  void run_chains_until(double seconds, End&& end) {
    const double begin = run_.spent(), rehearsal = begin + rehearsed_after * (seconds - begin);
    bool is_rehearsed = false;
    Pace pace(begin, rehearsal, steps_per_round * groups_.active());
    double now = begin;
    do {
      groups_.advance_to(groups_.steps() + pace.next(now, groups_.steps()));
      report(now / seconds, groups_.steps(), "sampling");
      if (run_.is_interrupted()) return;
      now = run_.spent();
      if (is_rehearsed || !pace.is_over(now)) continue;
      is_rehearsed = true;
      end();
      const double before = std::exchange(now, run_.spent());
      pace.end_at(seconds - (now - before));
    } while (!pace.is_over(now));
  }
  void report(double fraction, std::uint64_t samples, const char* phase) {
    run_.report({fraction, samples, run_.seconds(), phase});
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
    r.seed_seconds = seed_seconds;
    r.groups = settings_.groups;
    run_within(run_, [&] {
      normalize(r, film);
      judge(r, tally, draws, statistics);
    });
    r.seconds = run_.seconds();
    r.processor_seconds = run_.processor_seconds();
    return r;
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
  ChainGroups<Space, Chains> groups_;
};

// Chains of a kernel in path space; other groups are named by the caller.
template <class Space, class Kernel>
ChainRenderer(const Space&, const Kernel&, const Session&, ChainSettings)
    -> ChainRenderer<Space, PathGroup<Space, Kernel>>;

}  // namespace wander
