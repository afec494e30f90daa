// A group of chains of MMLT [Hachisuka, Kaplanyan and Dachsbacher 2014]: one chain for each length
// of paths, with a seed and a constant b_{g,n} of its own, both from the group's slice.
//
// Each step goes to one length: step j to the one in whose interval of the pmf q the number
// U + j φ mod 1 lies, with U uniform and φ the golden ratio.  Then the steps of length n are q_n N
// of N in expectation, exactly, and never far from it (Kronecker's sequence); a deposit has weight
// b_{g,n} / (q_n N), and the film is unbiased for any N.  q is a mixture of the light that all
// other groups found of that length and of equal shares; it must not know the group's own slice.
#pragma once

#include "mlt/primary/multiplexed_chain.h"
#include "mlt/primary/primary_estimator.h"
#include "mlt/run/group.h"

namespace wander {

// The share of steps that is spread over all lengths, whatever light they seem to carry.
inline constexpr double even_share_of_steps = 0.1;

// q_n at n - 2.
inline std::vector<double> shares_of_steps(const SeedTally& others) {
  std::vector<double> q(others.sum.size());
  const double total = others.total.value();
  const double even = total > 0 ? even_share_of_steps : 1;
  for (std::size_t k = 0; k < q.size(); ++k)
    q[k] = even / static_cast<double>(q.size()) +
           (total > 0 ? (1 - even) * others.sum[k].value() / total : 0);
  return q;
}

// The length of each step.
class LengthSequence {
 public:
  LengthSequence(std::vector<double> shares, double first)
      : shares_(std::move(shares)), place_(static_cast<std::uint64_t>(first * 0x1p64)) {}

  // n - 2
  std::size_t next() {
    double u = static_cast<double>(place_ >> 11) * 0x1p-53;
    place_ += 0x9E3779B97F4A7C15;  // φ - 1, as a fraction of 2^64
    std::size_t k = 0;
    while (k + 1 < shares_.size() && u >= shares_[k]) u -= shares_[k++];
    return k;
  }
  double share(std::size_t k) const { return shares_[k]; }

  // Where it stands; the shares are those that it was made with.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(place_);
  }

 private:
  std::vector<double> shares_;
  std::uint64_t place_;
};

template <class Space, class SmallStep, class Estimator>
class MmltGroup : public SeededGroup<Space, LengthSeeds> {
 public:
  using W = typename Space::Universe;
  using Kernel = PrimaryKernel<SmallStep>;

  MmltGroup(const Space& space, const Kernel& kernel, std::uint64_t seed, int group, int)
      : SeededGroup<Space, LengthSeeds>(space, seed, group, space.max_vertices() - 1, move_names()),
        kernel_(kernel),
        numbers_(seed, group, chains()) {}

  static constexpr std::span<const std::string_view> move_names() { return primary_move_names; }
  bool takes_steps() const { return slice_.found_light() || !Estimator::needs_seed; }
  int chains() const { return space_.max_vertices() - 1; }
  void keep_chains(int) {}  // it has one for each length

  void start_chains(const SeedTally& others) {
    if (!takes_steps()) return;
    this->expect_states();
    lengths_ = LengthSequence(shares_of_steps(others), numbers_.first_length());
    for (int k = 0; k < chains(); ++k) {
      const int n = k + 2;
      const double scale = 1 / lengths_.share(static_cast<std::size_t>(k));
      chains_.push_back({MultiplexedChain<Space, SmallStep>(space_, kernel_, n),
                         numbers_.chain(k),
                         RejectionRuns(primary_move_names.size()),
                         0,
                         {this->tally().mean(n), others.mean(n), kernel_.large_step},
                         scale,
                         static_cast<std::size_t>(k)});
      const Seed& seed = slice_.seed(k);
      if (seed.weight > 0) chains_.back().chain.start(slice_, seed, numbers_.place(k));
    }
  }

  void advance(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps; ++i) step(chains_[lengths_.next()]);
    steps_ += steps;
  }

  // Its chains have nothing in common that could be compared: each has a length of its own.
  void deliver(GroupsFilm& film, MutationStatistics& statistics, ChainDraws&) const {
    if (steps_ == 0) return film.add_dark_group();
    film.add(film_, 1, steps_);
    statistics.merge(statistics_);
  }

  GroupFindings findings() const {
    const double scale = steps_ > 0 ? 1 / static_cast<double>(steps_) : 0;
    return this->findings_of(
        scale, [&](std::size_t k) { return this->tally().mean(static_cast<int>(k) + 2); });
  }

  // Into a group whose chains have started from the same slices.
  template <class Archive>
  void serialize_chains(Archive& archive) {
    this->serialize_steps(archive);
    archive(lengths_);
    for (Member& member : chains_) archive(member.chain, member.runs, member.steps);
  }

 private:
  using Base = SeededGroup<Space, LengthSeeds>;
  using Base::film_;
  using Base::slice_;
  using Base::space_;
  using Base::statistics_;
  using Base::steps_;

  struct Member {
    MultiplexedChain<Space, SmallStep> chain;
    Rng random;
    RejectionRuns runs;
    std::uint64_t steps;
    PrimaryConstants constants;
    double scale;  // 1 / q_n
    std::size_t stratum;
  };

  void step(Member& member) {
    member.random.start(member.steps);
    statistics_.timed(member.steps++, [&] {
      int move = 0;
      member.chain.step(member.random, [&](const PrimaryStep<MultiplexedPath<W>>& step) {
        PrimaryDeposit weights = Estimator::deposit(step, member.constants);
        weights.current *= member.scale;
        weights.proposed *= member.scale;
        deposit(step, weights, film_);
        statistics_.observe(
            primary_observation(step, features_of(step.current), features_of(step.proposed)),
            member.runs);
        move = step.mutation();
      });
      return move;
    });
    const double total = member.chain.total();
    if (total > 0) this->keep_state(member.stratum, total / member.chain.techniques());
  }
  Features features_of(const MultiplexedPath<W>& sample) const {
    return sample.total > 0 ? features(space_, sample.path) : Features{};
  }

  Kernel kernel_;
  LengthNumbers numbers_;
  LengthSequence lengths_{{}, 0};
  std::vector<Member> chains_;
};

}  // namespace wander
