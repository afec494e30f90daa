// Every outcome of the draws of seeds, with its probability: each seed is each candidate with probability
// weight / Σ weights, whatever the others are.  Exact but for rounding.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "mlt/seeds/seeds.h"
#include "tests/support/enumeration.h"

namespace wander::test::reservoirs_test {
namespace {

// A uniform number that is not drawn before it is compared: u < share is a choice of two.
class Undrawn {
 public:
  explicit Undrawn(Enumeration& choices) : choices_(choices) {}
  bool operator<(double share) const {
    return choices_.choose(std::array<double, 2>{share, 1 - share}) == 0;
  }

 private:
  Enumeration& choices_;
};
struct UndrawnNumbers {
  Enumeration& choices;
  Undrawn uniform() { return Undrawn(choices); }
};

constexpr int seeds = 2;
using Weights = std::vector<double>;
// The probability of each pair of candidates, as the two seeds.
using Pairs = std::map<std::array<std::uint64_t, seeds>, double>;

template <class Kept>
Pairs pairs_of(const Weights& weights) {
  Pairs pairs;
  Enumeration choices;
  do {
    Kept kept(seeds);
    UndrawnNumbers random{choices};
    for (std::size_t i = 0; i < weights.size(); ++i)
      kept.offer(Seed{.sample = i, .vertices = 2, .technique = 0, .weight = weights[i]}, random);
    pairs[{kept[0].sample, kept[1].sample}] += choices.probability();
  } while (choices.advance());
  return pairs;
}

// The largest error of the probability that one seed is a candidate, and that both are a pair.
struct Errors {
  double of_seeds = 0, of_pairs = 0;
};
template <class Kept>
Errors errors_of(const Weights& weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  Pairs pairs = pairs_of<Kept>(weights);
  Errors errors;
  for (std::uint64_t i = 0; i < weights.size(); ++i) {
    double first = 0, second = 0;
    for (std::uint64_t j = 0; j < weights.size(); ++j) {
      const double expected = weights[i] / total * weights[j] / total;
      errors.of_pairs = std::max(errors.of_pairs, std::abs(pairs[{i, j}] - expected));
      first += pairs[{i, j}];
      second += pairs[{j, i}];
    }
    for (const double p : {first, second})
      errors.of_seeds = std::max(errors.of_seeds, std::abs(p - weights[i] / total));
  }
  return errors;
}

// Rising, falling, equal, of sizes far apart, alone; the last of them of no weight.
const std::vector<Weights> streams{
    {1, 2, 3, 4, 5}, {7, 0.5, 0.25, 3}, {1, 1, 1, 1, 1, 1}, {1e-9, 1e9, 3, 1e-3},
    {0.3},           {0.3, 2, 0}};

TEST(Reservoirs, HoldEachCandidateInProportionToItsWeightIndependently) {
  for (const Weights& weights : streams) {
    const Errors errors = errors_of<Reservoirs>(weights);
    EXPECT_LT(errors.of_seeds, rounding) << weights.size();
    EXPECT_LT(errors.of_pairs, rounding) << weights.size();
  }
}

// The twins share what is right, and offer otherwise.
class Twin {
 public:
  explicit Twin(int count) : kept_(static_cast<std::size_t>(count)) {}
  const Seed& operator[](int i) const { return kept_[static_cast<std::size_t>(i)]; }

 protected:
  std::vector<Seed> kept_;
  double total_ = 0;
};

// Of the weights so far it forgets that of the candidate, but for the first.
class ForgetsTheCandidate : public Twin {
 public:
  using Twin::Twin;
  template <class Random>
  void offer(const Seed& candidate, Random& random) {
    const double share = total_ > 0 ? std::min(1.0, candidate.weight / total_) : 1;
    total_ += candidate.weight;
    for (Seed& seed : kept_)
      if (random.uniform() < share) seed = candidate;
  }
};
// Each seed has the right law, but they are all the same.
class DrawsOnceForAll : public Twin {
 public:
  using Twin::Twin;
  template <class Random>
  void offer(const Seed& candidate, Random& random) {
    total_ += candidate.weight;
    if (random.uniform() < candidate.weight / total_) kept_.assign(kept_.size(), candidate);
  }
};

TEST(Reservoirs, WrongTwinsHoldThemOtherwise) {
  EXPECT_GT(errors_of<ForgetsTheCandidate>(streams.front()).of_seeds, 0.01);
  const Errors same = errors_of<DrawsOnceForAll>(streams.front());
  EXPECT_LT(same.of_seeds, rounding);
  EXPECT_GT(same.of_pairs, 0.01);
}

}  // namespace
}  // namespace wander::test::reservoirs_test
