// Metropolis light transport, in order.  Read this file first.
//
//   scene → seed pass → seeds and b → chains × mixture of mutations → steps → {film, statistics}
//
// Groups of chains are the unit of parallel work; they share nothing, and are merged in their
// order.
#pragma once

#include <memory>

#include "core/run.h"
#include "mlt/deposit.h"
#include "mlt/functionals.h"
#include "mlt/normalization.h"
#include "mlt/seed_pass.h"
#include "mlt/warnings.h"

namespace wander {

struct ChainSettings {
  int groups = 64;  // independent: their spread is the error bar
  int chains_per_group = 4;
  double seed_share = 0.25;  // of a time budget, and seed samples per mutation of a budget
  std::uint64_t fewest_seeds = 1 << 15;  // samples, of all groups together
};

// No sample of the seed pass found a path from a light to the sensor.
class NoLightFound : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A group: its slice of the seed pass, its chains, and what they deposit.
template <class Space, class Kernel>
class ChainGroup {
 public:
  using W = typename Space::Universe;

  ChainGroup(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains)
      : space_(space),
        kernel_(kernel),
        seed_(seed),
        first_chain_(group * chains),
        chain_count_(chains),
        slice_(space, seed, group, chains),
        film_(space.scene().bins(), space.max_vertices()),
        statistics_(Kernel::names, space.scene().bins(), space.max_vertices()) {}

  void add_seeds(std::uint64_t count) { slice_.run(count); }
  const SeedTally& tally() const { return slice_.tally(); }
  bool found_light() const { return slice_.found_light(); }

  void start_chains() {
    if (!found_light()) return;
    for (int k = 0; k < chain_count_; ++k) {
      const Path<W> path = slice_.replay(slice_.seed(k), space_.max_vertices());
      chains_.push_back({Chain<Space, Kernel>(space_, kernel_, path),
                         Rng(seed_, Purpose::chain, static_cast<std::uint32_t>(first_chain_ + k)),
                         features(space_, path), RejectionRuns(Kernel::count)});
    }
  }

  // Makes `steps` more steps, shared evenly among the chains.
  void advance(std::uint64_t steps) {
    const std::uint64_t target = this->steps() + steps;
    const auto count = static_cast<std::uint64_t>(chains_.size());
    for (std::uint64_t k = 0; k < count; ++k) {
      Member& member = chains_[k];
      const std::uint64_t share = target / count + (k < target % count ? 1 : 0);
      while (member.steps < share) step(member);
    }
    steps_ = target;
  }
  std::uint64_t steps() const { return steps_; }

  void deliver(GroupsFilm& film, MutationStatistics& statistics, ChainDraws& draws) const {
    if (steps_ == 0) return film.add_dark_group();
    film.add(film_, tally().mean(), steps_);
    statistics.merge(statistics_);
    for (const Member& member : chains_) draws.add(member.draws);
  }

 private:
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
    member.draws.offer([&] { return functionals(space_, member.chain.current()); });
  }

  const Space& space_;
  const Kernel& kernel_;
  std::uint64_t seed_;
  int first_chain_, chain_count_;
  SeedSlice<Space> slice_;
  std::vector<Member> chains_;
  GroupFilm film_;
  MutationStatistics statistics_;
  std::uint64_t steps_ = 0;
};

template <class Space, class Kernel>
class ChainRenderer {
 public:
  ChainRenderer(const Space& space, const Kernel& kernel, const Session& session,
                ChainSettings settings)
      : space_(space), session_(session), settings_(fitted(settings, session)), run_(session) {
    for (int g = 0; g < settings_.groups; ++g)
      groups_.push_back(
          std::make_unique<Group>(space, kernel, session.seed, g, settings_.chains_per_group));
  }

  Rendering render(const char* method) {
    seed_pass();
    const double seed_seconds = run_.seconds();
    const SeedTally tally = merged_tally();
    if (!(tally.total.value() > 0)) throw NoLightFound(no_light(tally.samples));
    in_parallel([](Group& group) { group.start_chains(); });
    run_chains();
    return rendering(method, tally, seed_seconds);
  }

 private:
  using Group = ChainGroup<Space, Kernel>;
  static constexpr std::uint64_t steps_per_round = 1024;  // of each group
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

  void in_parallel(const std::function<void(Group&)>& work) {
    run_parallel(run_, settings_.groups,
                 [&](int g) { work(*groups_[static_cast<std::size_t>(g)]); });
  }

  // Every slice has the same number of samples.
  void seed_pass() {
    const auto groups = static_cast<std::uint64_t>(settings_.groups);
    std::uint64_t per_group = std::numeric_limits<std::uint64_t>::max();
    double seconds = std::numeric_limits<double>::infinity();
    if (const auto* budget = std::get_if<SampleBudget>(&session_.budget)) {
      const double share = settings_.seed_share * static_cast<double>(budget->samples);
      per_group = std::max(settings_.fewest_seeds, static_cast<std::uint64_t>(share)) / groups;
    } else {
      seconds = settings_.seed_share * std::get<TimeBudget>(session_.budget).seconds;
    }
    for (std::uint64_t done = 0; done < per_group;) {
      const std::uint64_t count = std::min(seeds_per_round, per_group - done);
      in_parallel([&](Group& group) { group.add_seeds(count); });
      done += count;
      const double fraction = std::max(static_cast<double>(done) / static_cast<double>(per_group),
                                       run_.seconds() / seconds);
      run_.report({fraction, done * groups, run_.seconds(), "seed pass"});
      if (fraction >= 1 || run_.is_interrupted()) break;
    }
  }

  SeedTally merged_tally() const {
    SeedTally tally(space_.max_vertices());
    for (const auto& group : groups_) tally.merge(group->tally());
    return tally;
  }

  // Steps still to be made by each group that has chains, in one round or until the end.
  void run_chains() {
    std::vector<Group*> lit;
    for (const auto& group : groups_)
      if (group->found_light()) lit.push_back(group.get());
    const auto count = static_cast<std::uint64_t>(lit.size());
    const auto* budget = std::get_if<SampleBudget>(&session_.budget);
    const std::uint64_t target =
        budget ? budget->samples : std::numeric_limits<std::uint64_t>::max();
    const double seconds = budget ? std::numeric_limits<double>::infinity()
                                  : std::get<TimeBudget>(session_.budget).seconds;
    for (std::uint64_t done = 0; done < target;) {
      const std::uint64_t round = std::min(steps_per_round * count, target - done);
      run_parallel(run_, static_cast<int>(count), [&](int i) {
        const auto k = static_cast<std::uint64_t>(i);
        const std::uint64_t goal = (done + round) / count + (k < (done + round) % count ? 1 : 0);
        lit[k]->advance(goal - lit[k]->steps());
      });
      done += round;
      const double fraction = std::max(static_cast<double>(done) / static_cast<double>(target),
                                       run_.seconds() / seconds);
      run_.report({fraction, done, run_.seconds(), "sampling"});
      if (run_.seconds() >= seconds || run_.is_interrupted()) break;
    }
  }

  Rendering rendering(const char* method, const SeedTally& tally, double seed_seconds) const {
    const auto resolution = space_.scene().resolution();
    GroupsFilm film({resolution.begin(), resolution.end()});
    MutationStatistics statistics(Kernel::names, space_.scene().bins(), space_.max_vertices());
    ChainDraws draws;
    for (const auto& group : groups_) group->deliver(film, statistics, draws);
    const auto* budget = std::get_if<SampleBudget>(&session_.budget);
    Rendering r;
    r.complete = budget ? statistics.steps() == budget->samples : !run_.is_interrupted();
    r.method = method;
    r.samples = statistics.steps();
    r.seed = session_.seed;
    r.threads = run_.threads();
    r.seconds = run_.seconds();
    r.seed_seconds = seed_seconds;
    r.film = film.estimate();
    r.normalization = normalization(tally);
    r.groups = settings_.groups;
    r.chains = settings_.groups * settings_.chains_per_group;
    r.chains_record = diagnostics(draws);
    r.chains_record->longest_rejection_run = statistics.longest_rejection_run();
    r.mutations = statistics.records();
    if (rests_on_few_samples(tally)) r.film.reliable.assign(r.film.reliable.size(), false);
    r.warnings = warnings({tally, draws, *r.chains_record, statistics,
                           static_cast<std::size_t>(settings_.chains_per_group)});
    return r;
  }

  static std::string no_light(std::uint64_t samples) {
    return "the seed pass tried " + std::to_string(samples) +
           " bidirectional samples and found no light path from a light to the sensor, so no chain "
           "can start; look for walls without a gap, a light or sensor that faces away, or a "
           "max_vertices that is too small";
  }

  const Space& space_;
  const Session& session_;
  ChainSettings settings_;
  Run run_;
  std::vector<std::unique_ptr<Group>> groups_;
};

}  // namespace wander
