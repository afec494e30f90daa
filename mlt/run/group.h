// A group of chains with all that watches them: a film, statistics, and draws.  Groups share
// nothing; they are the unit of parallel work, and their spread is the error bar.
//
// Where the space has a map v (importance_map.h) the target is f v, and a deposit, or a state, counts
// 1/v times.
//
// How much a group does must not depend on its slice of the seed pass, or the product of its
// constant and what its chains deposit is biased.
//
// A group is a value that goes on: serialize_seeds(archive), and once its chains have started
// serialize_chains(archive), are its whole state.
#pragma once

#include <optional>
#include <utility>

#include "mlt/run/group_films.h"
#include "mlt/run/group_findings.h"
#include "mlt/run/seeded_chains.h"
#include "mlt/watch/functionals.h"
#include "mlt/watch/statistics.h"

namespace wander {

template <class G>
concept Group = ChainSource<G> &&
    requires(G& group, const G& made, std::uint64_t count, GroupsFilm& film,
             MutationStatistics& statistics, ChainDraws& draws, SharedFilm& pixels,
             TotalFilm& total, LargeSampleFilm& samples) {
  group.divide(Pooling{});  // before the first sample, if the film is pooled
  group.share(pixels, 1.0);
  group.share(pixels, total, 1.0);  // of a pooled film
  group.move_samples_to(samples);
  { made.light_of_deposits() } -> std::same_as<double>;
  group.advance(count);  // makes so many more steps, of all chains together
  { made.steps() } -> std::same_as<std::uint64_t>;
  made.deliver(film, statistics, draws);
  { made.findings() } -> std::same_as<GroupFindings>;
};

// `Chains` are the SeededChains of a method, who also say what its steps deposit, and what
// statistics see in them.
template <ChainSource Chains>
class ChainGroup {
 public:
  using Source = Chains;
  using Space = typename Chains::Space;
  using Kernel = typename Chains::Kernel;

  ChainGroup(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains,
             const FilmLayout& layout = {})
      : source_(space, kernel, seed, group, chains, layout),
        layout_(layout),
        film_(space.scene().film_shape(), space.max_vertices(), layout),
        states_(source_.evidence().ratios.size()),
        counts_(states_.size()),
        statistics_(move_names(), layout.maps_of(space.scene().resolution()),
                    space.max_vertices()) {}

  static constexpr std::span<const std::string_view> move_names() { return Chains::move_names(); }
  void divide(const Pooling& pooling) {
    const Space& space = source_.space();
    parts_.emplace_back(pooling, space.scene().film_shape(), space.max_vertices(), layout_);
  }
  // Before the chains start, and beside them.
  void add_seeds(std::uint64_t count) {
    if (parts_.empty()) return source_.add_seeds(count);
    using W = typename Space::Universe;
    source_.add_seeds(count, SampleWatcher<W, Chains::Seeds::ratios>(parts_.front()));
  }
  const SeedTally& tally() const { return source_.tally(); }
  const SeedTally& seed_tally() const { return source_.seed_tally(); }
  void end_seeds() { source_.end_seeds(); }
  void keep_chains(int most) { source_.keep_chains(most); }
  bool takes_steps() const { return source_.takes_steps(); }
  int chains() const { return source_.chains(); }
  std::uint64_t steps() const { return steps_; }

  void start_chains(const SeedTally& others) {
    source_.start_chains(others);
    if (!takes_steps()) return;
    expect_states();
    turns_ = source_.turns();
    members_.resize(static_cast<std::size_t>(chains()));
    if (!Chains::has_comparable_chains) return;
    draws_.reserve(members_.size());
    for (std::size_t k = 0; k < members_.size(); ++k)
      draws_.emplace_back(ThinnedDraws::capacity_of(members_.size()));
  }

  void advance(std::uint64_t steps) {
    statistics_.expect(steps);
    turns_->take(steps, [this](std::size_t k) { step(k); });
    steps_ += steps;
  }

  // Of a large film, once the chains have started: where the pixels of what they deposit go,
  void share(SharedFilm& pixels, double factor) { film_.share(pixels, factor); }
  // if it is pooled, of their part of it and of all.
  void share(SharedFilm& pixels, TotalFilm& total, double factor) {
    parts_.front().of_chains().share(pixels, factor);
    film_.share(total, factor);
  }
  void move_samples_to(LargeSampleFilm& film) { parts_.front().move_samples_to(film); }
  // What its deposits, over the number of its steps, have to be multiplied by to be light.
  double light_of_deposits() const {
    return Chains::deposits == Deposits::shares ? seed_tally().mean_measure() : 1;
  }

  void deliver(GroupsFilm& film, MutationStatistics& statistics, ChainDraws& draws) const {
    if (steps_ == 0) return film.add_dark_group();
    film.add(film_, light_of_deposits(), steps_);
    statistics.merge(statistics_);
    if (!source_.found_light()) return;  // draws of chains that began in the dark are of nothing
    for (const ThinnedDraws& chain : draws_) draws.add(chain);
  }

  GroupFindings findings() const {
    const double scale = steps_ > 0 ? light_of_deposits() / static_cast<double>(steps_) : 0;
    GroupFindings found{&tally(), &seed_tally(), &source_.evidence(), &film_, parts_, scale};
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const double count = counts_[k];
      found.states.push_back(
          {&states_[k], count > 0 ? Chains::Seeds::measure(seed_tally(), k) / count : 0});
    }
    if (Chains::deposits == Deposits::shares)
      for (const auto& visits : statistics_.visits())
        found.classes.push_back({visits.path_class, scale * static_cast<double>(visits.steps)});
    return found;
  }

  // Between two samples of the seed pass, or after it.
  template <class Archive>
  void serialize_seeds(Archive& archive) {
    archive(source_);
    for (PooledParts& parts : parts_) archive(parts);
  }
  // Between two steps.  What follows from the slices is left out: start_chains() makes it again.
  template <class Archive>
  void serialize_chains(Archive& archive) {
    archive(steps_, film_, states_, counts_, statistics_);
    if (turns_) archive(*turns_);
    for (std::size_t k = 0; k < members_.size(); ++k) {
      bool has_begun = members_[k].has_value();
      archive(has_begun);
      if (!has_begun) continue;
      Member& of_chain = member(k);
      archive(of_chain.chain, of_chain.current, of_chain.runs);
    }
    for (ThinnedDraws& chain : draws_) archive(chain);
  }

 private:
  struct Member {
    RunningChain<typename Chains::Chain> chain;
    Features current;  // of its state
    RejectionRuns runs;
  };

  // A chain begins with its first step, and allocates then.
  Member& member(std::size_t k) {
    std::optional<Member>& of_chain = members_[k];
    if (!of_chain) {
      auto chain = source_.chain(static_cast<int>(k));
      const Features start = source_.features_of(chain.chain.current());
      of_chain.emplace(Member{std::move(chain), start, RejectionRuns(move_names().size())});
    }
    return *of_chain;
  }

  void step(std::size_t k) {
    Member& member = this->member(k);
    statistics_.timed(member.chain.steps, [&] {
      int mutation = 0;
      member.chain.step([&](const auto& step) {
        source_.for_each_deposit(
            static_cast<int>(k), step, member.current,
            [this](const auto& state, int vertices, int bin, double share, const auto& colour) {
              const double weight = share * light_of_measure(source_.space(), bin);
              film_.add(vertices, bin, weight, colour);
              for (PooledParts& parts : parts_) {
                const double w_M = parts.partition().of_chains(source_.ratio(state));
                parts.of_chains().add(vertices, bin, weight * w_M, colour);
              }
            });
        const Observation seen = source_.observation(step, member.current);
        statistics_.observe(seen, member.runs);
        if (step.accepted()) member.current = source_.features_of(step.proposed);
        mutation = seen.mutation;
      });
      return mutation;
    });
    // In a group that found no light there is nothing to compare states with.
    if (!source_.found_light() || member.current.is_dark()) return;
    const auto& state = member.chain.chain.current();
    const std::size_t stratum = Chains::stratum(static_cast<int>(k));
    const double ratio = source_.ratio(state),
                 light = light_of_measure(source_.space(), member.current.bin);
    states_[stratum].add_within(ratio, light);
    ++counts_[stratum];
    if constexpr (Chains::deposits == Deposits::shares)
      if (!parts_.empty()) parts_.front().add_state(member.current.path_class, ratio, light);
    if constexpr (Chains::has_comparable_chains)
      draws_[k].offer([&] { return source_.functionals_of(state); });
  }

  // Before the first step, so that none allocates.
  void expect_states() {
    constexpr int octaves = 24;  // beyond which a state tells the bridge nothing new
    for (std::size_t k = 0; k < states_.size(); ++k)
      states_[k].make_room(source_.evidence().ratios[k], octaves);
  }

  Chains source_;
  FilmLayout layout_;
  GroupFilm film_;
  std::vector<PooledParts> parts_;      // one, if the film is pooled
  std::vector<RatioHistogram> states_;  // by stratum: f / p̄ of the state after each step
  std::vector<double> counts_;          // by stratum: of the steps
  MutationStatistics statistics_;
  std::optional<typename Chains::Turns> turns_;  // once the chains have started
  std::vector<std::optional<Member>> members_;   // by chain; none before its first step
  std::vector<ThinnedDraws> draws_;              // by chain; empty where chains cannot be compared
  std::uint64_t steps_ = 0;
};

}  // namespace wander
