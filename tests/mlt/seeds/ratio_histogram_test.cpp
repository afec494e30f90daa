// A histogram of ratios keeps sums of smooth functions, and its bins are cut out of the bits.
#include "mlt/seeds/ratio_histogram.h"

#include <gtest/gtest.h>

#include <cereal/archives/binary.hpp>
#include <cmath>
#include <sstream>

#include "core/rng.h"

namespace wander::test {
namespace {

std::vector<double> ratios(std::uint64_t seed) {
  Rng random(seed, Purpose::test, 71);
  std::vector<double> values;
  for (int i = 0; i < 20'000; ++i) {
    const double u = random.uniform();
    values.push_back(std::exp(30 * u - 15));
  }
  return values;
}

RatioHistogram histogram_of(const std::vector<double>& values) {
  RatioHistogram histogram;
  for (const double value : values) histogram.add(value);
  return histogram;
}

TEST(RatioHistogram, SumsSmoothFunctionsToTheSecondOrderOfItsBins) {
  const std::vector<double> values = ratios(1);
  const RatioHistogram histogram = histogram_of(values);
  EXPECT_EQ(histogram.count(), 20'000);
  for (const double b : {1e-5, 0.1, 1.0, 40.0, 1e6}) {
    double exact = 0, binned = 0;
    for (const double l : values) exact += l / (l + b);
    for (int i = histogram.first(); i < histogram.end(); ++i) {
      const auto bin = histogram[i];
      if (bin.count > 0) binned += bin.count * (bin.sum / bin.count) / (bin.sum / bin.count + b);
    }
    EXPECT_NEAR(binned, exact, 1e-5 * exact) << b;
  }
}

TEST(RatioHistogram, IsShiftedByPowersOfTwoAndElseTheSame) {
  std::vector<double> values = ratios(2);
  const RatioHistogram histogram = histogram_of(values);
  for (double& value : values) value *= 0x1p+40;
  const RatioHistogram scaled = histogram_of(values);
  const int shift = 40 << RatioHistogram::bits_per_octave;
  ASSERT_EQ(scaled.first(), histogram.first() + shift);
  ASSERT_EQ(scaled.end(), histogram.end() + shift);
  for (int i = histogram.first(); i < histogram.end(); ++i) {
    EXPECT_EQ(scaled[i + shift].count, histogram[i].count);
    EXPECT_EQ(scaled[i + shift].sum, 0x1p+40 * histogram[i].sum);
  }
}

TEST(RatioHistogram, WithoutTheLargestHoldsTheOthers) {
  RatioHistogram histogram;
  for (const double l : {1.0, 64.0, 64.0}) histogram.add(l);
  const RatioHistogram two = histogram.without_largest(), one = two.without_largest();
  EXPECT_DOUBLE_EQ(two.count(), 2);
  EXPECT_DOUBLE_EQ(two[two.end() - 1].sum, 64);
  EXPECT_DOUBLE_EQ(one.count(), 1);
  EXPECT_DOUBLE_EQ(one[one.first()].sum, 1);
  EXPECT_DOUBLE_EQ(one.without_largest().without_largest().count(), 0);
}

TEST(RatioHistogram, OfTwoIsTheirSumWhereverTheyLie) {
  RatioHistogram low, high;
  for (const double l : {1e-3, 2e-3}) low.add(l);
  for (const double l : {1e3, 1.0}) high.add(l);
  for (const bool low_first : {true, false}) {
    RatioHistogram sum;
    sum.add(low_first ? low : high, 1);
    sum.add(low_first ? high : low, 3);
    EXPECT_EQ(sum.count(), low_first ? 8 : 2 + 2 * 3);
    for (int i = sum.first(); i < sum.end(); ++i)
      EXPECT_EQ(sum[i].sum, (low_first ? 1 : 3) * low[i].sum + (low_first ? 3 : 1) * high[i].sum);
  }
  RatioHistogram nothing, sum;
  sum.add(nothing, 1);
  EXPECT_EQ(sum.count(), 0);
}

TEST(RatioHistogram, WithRoomDoesNotGrowAndKeepsWhatIsBeyondAtItsEdge) {
  RatioHistogram seen, histogram;
  histogram.add_within(1);
  EXPECT_EQ(histogram.count(), 0) << "no room at all";
  seen.add(1);
  histogram.make_room(seen, 2);
  const int first = histogram.first(), end = histogram.end();
  for (const double l : {1e-9, 0.5, 1.0, 3.9, 1e9}) histogram.add_within(l);
  EXPECT_EQ(histogram.first(), first);
  EXPECT_EQ(histogram.end(), end);
  EXPECT_EQ(histogram.count(), 5);
  EXPECT_EQ(histogram[first].sum, 1e-9);
  EXPECT_EQ(histogram[end - 1].count, 1);
}

TEST(RatioHistogram, ComesOutOfAnArchiveAsItWentIn) {
  RatioHistogram room;
  room.make_room(histogram_of({1e-3, 2.0, 2.01, 1e5}), 1);  // holds nothing, and has its room
  room.add_within(3.0);
  for (const RatioHistogram& one : {histogram_of(ratios(2)), room, RatioHistogram{}}) {
    std::stringstream bytes;
    cereal::BinaryOutputArchive out(bytes);
    out(one);
    RatioHistogram other = histogram_of({7.0});
    cereal::BinaryInputArchive in(bytes);
    in(other);
    ASSERT_EQ(other.first(), one.first());
    ASSERT_EQ(other.end(), one.end());
    for (int i = one.first(); i < one.end(); ++i) {
      EXPECT_EQ(other[i].count, one[i].count) << i;
      EXPECT_EQ(other[i].sum, one[i].sum) << i;
    }
  }
}

}  // namespace
}  // namespace wander::test
