// Scaled products and compensated sums.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/scaled.h"
#include "statistics/sum.h"
#include "tests/support/generator.h"

namespace wander::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Scaled, HoldsEveryFiniteDoubleExactly) {
  Generator generator(1);
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::bit_cast<double>(generator.bits());
    if (!std::isfinite(x)) continue;
    ASSERT_EQ(Scaled(x).value(), x);
    ASSERT_EQ(std::signbit(Scaled(x).value()), std::signbit(x));
  }
  for (const double x : {0.0, 1.0, -1.0, 0x1p-1022, 0x1p-1074, 0x1.fffffffffffffp1023, 3e-310})
    EXPECT_EQ(Scaled(x).value(), x);
}

TEST(Scaled, KeepsItsMantissaBetweenOneAndTwo) {
  Generator generator(2);
  for (int i = 0; i < 10'000; ++i) {
    const double x = std::bit_cast<double>(generator.bits() & ~(std::uint64_t{1} << 63));
    if (!std::isfinite(x) || x == 0) continue;
    const Scaled s(x);
    ASSERT_GE(s.mantissa(), 1);
    ASSERT_LT(s.mantissa(), 2);
  }
  EXPECT_EQ(Scaled(0x1p-1074).exponent(), -1074);
  EXPECT_EQ(Scaled(0).exponent(), 0);
}

TEST(Scaled, MultipliesFarBeyondTheRangeOfDouble) {
  Scaled product = 1;
  for (int i = 0; i < 100'000; ++i) product *= 0.15;
  EXPECT_EQ(product.value(), 0);
  EXPECT_FALSE(product.is_zero());
  EXPECT_NEAR(product.log(), 100'000 * std::log(0.15), 1e-7);
  for (int i = 0; i < 100'000; ++i) product /= 0.15;
  EXPECT_NEAR(product.value(), 1, 1e-10);
  EXPECT_EQ((Scaled(1e300) * Scaled(1e300)).value(), infinity);
  EXPECT_EQ((Scaled(1e300) * Scaled(1e300) / Scaled(1e300)).value(), 1e300);
  EXPECT_EQ(Scaled::of(-1.5, 1'000'000).value(), -infinity);
  EXPECT_EQ(Scaled::of(1.5, -1'000'000).value(), 0);
}

TEST(Scaled, RoundsProductsAndQuotientsAsDoubleDoes) {
  Generator generator(3);
  for (int i = 0; i < 100'000; ++i) {
    const double a =
        std::ldexp(generator.uniform() - 0.5, static_cast<int>(60 * generator.uniform()));
    const double b =
        std::ldexp(generator.uniform() + 0.1, static_cast<int>(60 * generator.uniform()));
    ASSERT_EQ((Scaled(a) * Scaled(b)).value(), a * b);
    ASSERT_EQ((Scaled(a) / Scaled(b)).value(), a / b);
    ASSERT_EQ((Scaled(a) + Scaled(b)).value(), a + b);
  }
}

TEST(Scaled, IsBlindToPowersOfTwo) {
  Generator generator(4);
  for (const std::int64_t power : {-30'000, -1000, -100, 1, 100, 5000}) {
    const Scaled unit = Scaled::of(1, power);
    for (int i = 0; i < 1000; ++i) {
      const double a = generator.uniform() + 1e-9, b = generator.uniform() + 1e-9;
      const Scaled product = Scaled(a) * Scaled(b), sum = Scaled(a) + Scaled(b);
      ASSERT_EQ((unit * Scaled(a)) * Scaled(b), unit * product);
      ASSERT_EQ(unit * Scaled(a) + unit * Scaled(b), unit * sum);
      ASSERT_EQ((unit * Scaled(a)) / (unit * Scaled(b)), Scaled(a) / Scaled(b));
    }
  }
}

TEST(Scaled, AddsNumbersOfAnyDistance) {
  EXPECT_EQ(Scaled::of(1, 5000) + Scaled::of(1, 5000), Scaled::of(1, 5001));
  EXPECT_EQ(Scaled::of(1, 5000) + Scaled::of(1, -5000), Scaled::of(1, 5000));
  EXPECT_EQ(Scaled::of(1, -5000) + Scaled::of(1, 5000), Scaled::of(1, 5000));
  EXPECT_EQ(Scaled::of(1, 5000) + Scaled::of(1, 4960), Scaled::of(1 + 0x1p-40, 5000));
  EXPECT_EQ(Scaled::of(1, -5000) + Scaled(0), Scaled::of(1, -5000));
  EXPECT_EQ(Scaled(0) + Scaled::of(1, -5000), Scaled::of(1, -5000));
  EXPECT_TRUE((Scaled::of(1, -5000) + Scaled::of(-1, -5000)).is_zero());
  Scaled sum;
  for (int i = 0; i < 1024; ++i) sum += Scaled::of(1, -3000);
  EXPECT_EQ(sum, Scaled::of(1, -2990));
}

TEST(Scaled, HasZeroAsItsOnlyNumberWithoutSignOfLife) {
  const Scaled zero = Scaled::of(1, 4000) * Scaled(0);
  EXPECT_EQ(zero, Scaled(0));
  EXPECT_EQ(zero.value(), 0);
  EXPECT_FALSE(zero.is_positive());
  EXPECT_EQ(zero.log(), -infinity);
}

TEST(Scaled, ShowsWhatIsNotFiniteInProducts) {
  for (const double bad : {infinity, nan}) {
    for (const Scaled s :
         {Scaled(bad), Scaled(bad) * Scaled::of(1, 3000), Scaled(bad) * Scaled::of(1, -3000),
          Scaled::of(1, -3000) * Scaled(bad)}) {
      EXPECT_FALSE(s.is_finite());
      EXPECT_FALSE(s.is_positive());
      EXPECT_FALSE(s.is_zero());
    }
  }
  EXPECT_FALSE((Scaled(1) / Scaled(0)).is_finite());
  EXPECT_TRUE(std::isnan((Scaled(0) / Scaled(0)).value()));
  EXPECT_TRUE(std::isnan((Scaled(infinity) * Scaled(0)).value()));
}

TEST(Scaled, ShowsWhatIsNotFiniteInSums) {
  for (const double bad : {infinity, nan})
    for (const std::int64_t power : {-3000, -200, 0, 200, 3000}) {
      EXPECT_FALSE((Scaled(bad) + Scaled::of(1, power)).is_finite()) << bad << " + 2^" << power;
      EXPECT_FALSE((Scaled::of(1, power) + Scaled(bad)).is_finite())
          << "2^" << power << " + " << bad;
    }
}

TEST(Scaled, TakesLogarithmsOfAnySize) {
  EXPECT_DOUBLE_EQ(Scaled(2).log(), std::log(2.0));
  EXPECT_DOUBLE_EQ(Scaled::of(1, -100'000).log(), -100'000 * std::log(2.0));
  EXPECT_TRUE(std::isnan(Scaled(-1).log()));
}

TEST(Sum, KeepsWhatAPlainSumLoses) {
  Sum sum;
  for (const double x : {1.0, 1e100, 1.0, -1e100}) sum += x;
  EXPECT_EQ(sum.value(), 2);
}

TEST(Sum, MergesWithItsLostBits) {
  Sum a, b;
  for (const double x : {1.0, 1e100}) a += x;
  for (const double x : {1.0, -1e100}) b += x;
  a += b;
  EXPECT_EQ(a.value(), 2);
}

TEST(Sum, DoesNotStagnateUnderManySmallTerms) {
  Sum sum;
  double plain = 0;
  sum += 1e16;
  plain += 1e16;
  for (int i = 0; i < 1'000'000; ++i) {
    sum += 0.5;
    plain += 0.5;
  }
  EXPECT_EQ(plain, 1e16);  // what would happen otherwise
  EXPECT_EQ(sum.value(), 1e16 + 500'000);
}

}  // namespace
}  // namespace wander::test
