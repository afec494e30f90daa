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

using Weights = std::vector<double>;

// Numbers that a reservoir draws while it is offered candidate `at`.  What comes of one depends only on between
// which of 1 - W_at / W_k, k ≥ at, it lies: one of each interval stands for all, with the interval's probability.
struct NumbersByInterval {
  Enumeration& choices;
  std::vector<double> sums;  // W
  std::size_t at = 0;

  double uniform() {
    std::vector<double> ends;
    for (std::size_t k = at; k < sums.size(); ++k) ends.push_back(1 - sums[at] / sums[k]);
    ends.push_back(1);
    std::vector<double> lengths;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) lengths.push_back(ends[k + 1] - ends[k]);
    const auto k = static_cast<std::size_t>(choices.choose(lengths));
    return (ends[k] + ends[k + 1]) / 2;
  }
};
std::vector<double> sums_of(const Weights& weights) {
  std::vector<double> sums(weights.size());
  std::partial_sum(weights.begin(), weights.end(), sums.begin());
  return sums;
}

constexpr int seeds = 2;
// The probability of each pair of candidates, as the two seeds.
using Pairs = std::map<std::array<std::uint64_t, seeds>, double>;

template <class Kept>
Pairs pairs_of(const Weights& weights) {
  Pairs pairs;
  Enumeration choices;
  do {
    Kept kept(seeds);
    NumbersByInterval random{choices, sums_of(weights)};
    for (; random.at < weights.size(); ++random.at)
      kept.offer(Seed{random.at, 2, 0, weights[random.at]}, random);
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

// The twins share what is right, and offer otherwise.  Where they jump by other sums one number of an interval does not
// stand for all, and their errors are not exact; they are far from none.
class Twin {
 public:
  explicit Twin(int count) : kept_(static_cast<std::size_t>(count)) {}
  const Seed& operator[](int i) const { return kept_[static_cast<std::size_t>(i)].seed; }

 protected:
  struct Kept {
    Seed seed{};
    double end = 0;
  };
  std::vector<Kept> kept_;
  double total_ = 0;
};

// Of the weights so far it forgets that of the candidate.
class ForgetsTheCandidate : public Twin {
 public:
  using Twin::Twin;
  template <class Random>
  void offer(const Seed& candidate, Random& random) {
    const double before = total_;
    total_ += candidate.weight;
    for (Kept& kept : kept_)
      if (total_ > kept.end) kept = {candidate, before / (1 - random.uniform())};
  }
};
// Each seed has the right law, but they are all the same.
class DrawsOnceForAll : public Twin {
 public:
  using Twin::Twin;
  template <class Random>
  void offer(const Seed& candidate, Random& random) {
    total_ += candidate.weight;
    if (!(total_ > kept_.front().end)) return;
    kept_.assign(kept_.size(), {candidate, total_ / (1 - random.uniform())});
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
