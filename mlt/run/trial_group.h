// A group of chains of which everything is kept in a log (trial_log.h): short, and thrown away.
#pragma once

#include <optional>
#include <utility>

#include "mlt/run/seeded_chains.h"
#include "mlt/run/trial_log.h"
#include "mlt/watch/functionals.h"

namespace wander {

template <ChainSource Chains>
class TrialGroup {
 public:
  using Space = typename Chains::Space;
  using Kernel = typename Chains::Kernel;

  TrialGroup(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int chains,
             const FilmLayout& layout)
      : source_(space, kernel, seed, group, chains, layout) {}

  static constexpr std::span<const std::string_view> move_names() { return Chains::move_names(); }
  void add_seeds(std::uint64_t count) {
    source_.add_seeds(count, SampleLogger<Space, Chains::Seeds::ratios>(log_));
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
    turns_ = source_.turns();
    members_.resize(static_cast<std::size_t>(chains()));
  }
  void advance(std::uint64_t steps) {
    turns_->take(steps, [this](std::size_t k) { step(k); });
    steps_ += steps;
  }

  TrialFindings findings() const {
    TrialFindings found{&log_, static_cast<double>(tally().rays)};
    found.light_of_states.resize(source_.evidence().ratios.size());
    for (const TrialLog::State& state : log_.states) ++found.light_of_states[state.stratum];
    for (std::size_t k = 0; k < found.light_of_states.size(); ++k)
      if (double& light = found.light_of_states[k]; light > 0)
        light = Chains::Seeds::measure(seed_tally(), k) / light;
    return found;
  }

  // Between two samples of the seed pass.
  template <class Archive>
  void serialize_seeds(Archive& archive) {
    archive(source_, log_.samples, log_.found);
  }

 private:
  struct Member {
    RunningChain<typename Chains::Chain> chain;
    Features current;  // of its state
  };

  // A chain begins with its first step.
  Member& member(std::size_t k) {
    std::optional<Member>& of_chain = members_[k];
    if (!of_chain) {
      auto chain = source_.chain(static_cast<int>(k));
      const Features start = source_.features_of(chain.chain.current());
      of_chain.emplace(Member{std::move(chain), start});
    }
    return *of_chain;
  }

  void step(std::size_t k) {
    Member& member = this->member(k);
    member.chain.step([&](const auto& step) {
      source_.for_each_deposit(static_cast<int>(k), step, member.current,
                               [this](const auto& state, int, int bin, double weight, const auto&) {
                                 log_.deposits.push_back({bin, weight, source_.ratio(state)});
                               });
      if (step.accepted()) member.current = source_.features_of(step.proposed);
    });
    if (!source_.found_light() || member.current.is_dark()) return;
    log_.states.push_back({member.current.bin, Chains::stratum(static_cast<int>(k)),
                           source_.ratio(member.chain.chain.current())});
  }

  Chains source_;
  TrialLog log_;
  std::optional<typename Chains::Turns> turns_;  // once the chains have started
  std::vector<std::optional<Member>> members_;   // by chain; none before its first step
  std::uint64_t steps_ = 0;
};

}  // namespace wander
