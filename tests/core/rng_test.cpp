// The generator: Philox4x32-10 against its published answers and against the authors' own code, and
// what the program asks of it: independent streams, numbers in [0, 1), choices that never happen.
#include "core/rng.h"

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tests/support/chi_square.h"
#include "tests/support/expect.h"
#include "tests/support/generator.h"

namespace wander::test {
namespace {

using Block = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

TEST(Philox, GivesThePublishedAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, EqualsRandom123OnRandomCounters) {
  Generator generator(1);
  const auto word = [&] { return static_cast<std::uint32_t>(generator.bits() >> 32); };
  for (int i = 0; i < 20'000; ++i) {
    const Block counter{word(), word(), word(), word()};
    const Key key{word(), word()};
    const philox4x32_ctr_t their_counter{{counter[0], counter[1], counter[2], counter[3]}};
    const philox4x32_key_t their_key{{key[0], key[1]}};
    const philox4x32_ctr_t theirs = philox4x32_R(10, their_counter, their_key);
    ASSERT_EQ(philox(counter, key), (Block{theirs.v[0], theirs.v[1], theirs.v[2], theirs.v[3]}));
  }
}

std::vector<double> first_numbers(Rng rng, std::uint64_t step, int count) {
  rng.start(step);
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(rng.uniform());
  return numbers;
}

TEST(Rng, DrawsAStepAgainWithTheSameNumbers) {
  Rng rng(7, Purpose::test, 3);
  rng.start(5);
  const double first = rng.uniform();
  rng.uniform();
  rng.uniform();  // an odd count: half a block is left over, and must not leak into the next step
  rng.start(5);
  EXPECT_EQ(rng.uniform(), first);
}

// The bits are those of Philox with the counter (block, step, stream), and a key by splitmix64
// [Steele, Lea and Flood 2014] of the seed and the purpose; 53 of 64 make a number.
TEST(Rng, IsPhiloxOfItsName) {
  constexpr std::uint64_t seed = 0x123456789abcdef0, step = 0x500000009;
  constexpr std::uint32_t stream = 7;
  std::uint64_t z = seed + 0x9E3779B97F4A7C15 * (static_cast<std::uint64_t>(Purpose::chain) + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  z ^= z >> 31;
  std::vector<double> expected;
  for (const std::uint32_t block : {0u, 1u, 2u}) {
    const auto r = philox({block, 9, 5, stream},
                          {static_cast<std::uint32_t>(z), static_cast<std::uint32_t>(z >> 32)});
    for (const int k : {0, 2}) {
      const auto i = static_cast<std::size_t>(k);
      const std::uint64_t bits = (std::uint64_t{r[i]} << 32) | r[i + 1];
      expected.push_back(std::ldexp(static_cast<double>(bits >> 11), -53));
    }
  }
  EXPECT_EQ(first_numbers(Rng(seed, Purpose::chain, stream), step, 6), expected);
}

TEST(Rng, NeverSharesANumberBetweenSeedsPurposesStreamsOrSteps) {
  std::set<double> seen;
  std::size_t drawn = 0;
  for (const std::uint64_t seed : {0ull, 1ull, 2ull, 0xffffffffffffffffull})
    for (const Purpose purpose :
         {Purpose::estimate, Purpose::seed_pass, Purpose::resample, Purpose::chain, Purpose::test})
      for (const std::uint32_t stream : {0u, 1u, 0xffffffffu})
        for (const std::uint64_t step : {0ull, 1ull, 0x100000000ull, 0xffffffffffffffffull})
          for (const double number : first_numbers(Rng(seed, purpose, stream), step, 8)) {
            seen.insert(number);
            ++drawn;
          }
  // 1920 numbers of 53 bits: a collision by chance has probability 2e-10.
  EXPECT_EQ(seen.size(), drawn);
}

TEST(Rng, IsUniformAndItsNeighboursAreIndependent) {
  Rng rng(1, Purpose::test, 0);
  auto pair = [&, step = std::uint64_t{0}]() mutable -> std::optional<CubePoint<2>> {
    rng.start(step++);  // the first two numbers of successive steps, as estimators use them
    const double u = rng.uniform();
    return CubePoint<2>{u, rng.uniform()};
  };
  const auto one = [](const CubePoint<2>&) { return 1.0; };
  EXPECT_TRUE(passes((sampler_matches_density<2>(pair, one))));
  // Control: a stream that draws its second number from the first.
  auto tied = [&, step = std::uint64_t{0}]() mutable -> std::optional<CubePoint<2>> {
    rng.start(step++);
    const double u = rng.uniform();
    return CubePoint<2>{u, 0.95 * rng.uniform() + 0.05 * u};
  };
  EXPECT_TRUE(rejects((sampler_matches_density<2>(tied, one))));
}

TEST(Rng, StaysInTheHalfOpenUnitInterval) {
  Rng rng(3, Purpose::test, 1);
  for (int i = 0; i < 1'000'000; ++i) {
    const double u = rng.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
  }
}

TEST(Rng, ChoosesInProportionAndNeverWhatHasNoProbability) {
  const std::vector<double> pmf{0, 0.1, 0, 0.25, 0.6, 0.05, 0};
  Rng rng(4, Purpose::test, 2);
  std::vector<double> counts(pmf.size()), expected;
  constexpr int draws = 200'000;
  for (int i = 0; i < draws; ++i) ++counts[static_cast<std::size_t>(rng.choose(pmf))];
  for (const double p : pmf) expected.push_back(p * draws);
  EXPECT_TRUE(passes(chi_square_test(counts, expected, usual_false_alarm)));
  for (const std::size_t never : {0u, 2u, 6u}) EXPECT_EQ(counts[never], 0);
}

// A pmf whose entries sum to a little less than 1 in floating point: the rest goes to an entry that
// can occur, not to the zero behind it.
TEST(Rng, GivesWhatRoundingLeavesOverToAnEntryThatCanOccur) {
  const std::vector<double> pmf{0.3, 0.2, 0, 0};  // half is missing
  Rng rng(5, Purpose::test, 0);
  for (int i = 0; i < 1000; ++i) ASSERT_LE(rng.choose(pmf), 1);
}

TEST(Rng, ChoosesAmongEqualsUniformly) {
  Rng rng(6, Purpose::test, 0);
  std::vector<double> counts(7);
  for (int i = 0; i < 140'000; ++i) ++counts[static_cast<std::size_t>(rng.choose(7))];
  EXPECT_TRUE(passes(chi_square_test(counts, std::vector<double>(7, 20'000.0), usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test
