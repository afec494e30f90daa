// The choice of a light: an interval of numbers for each, as long as its probability, from which its number is told again.
#include "core/light_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/rng.h"

namespace wander::test::light_choice_test {
namespace {

// Of very different powers.
std::vector<double> powers_of(std::size_t lights, std::uint64_t seed) {
  Rng random(seed, Purpose::test, 91);
  std::vector<double> powers;
  for (std::size_t k = 0; k < lights; ++k) powers.push_back(std::exp(20 * random.uniform()));
  return powers;
}

TEST(LightChoice, IsOfTheLightWhoseIntervalHoldsTheNumber) {
  const LightChoice choice(std::vector{1., 5., 2.});
  EXPECT_EQ(choice.size(), 3u);
  EXPECT_EQ(choice.probability(1), 5. / 8);
  for (const auto& [number, light] :
       {std::pair(0., 0u), {0.1249, 0u}, {0.125, 1u}, {0.7499, 1u}, {0.75, 2u}})
    EXPECT_EQ(choice(number), light) << number;
  EXPECT_EQ(choice(std::nextafter(1., 0.)), 2u);
  EXPECT_EQ(LightChoice(std::vector{3.})(0.5), 0u);
}

TEST(LightChoice, IsToldFromTheLight) {
  for (const std::size_t lights : {1, 2, 3, 40, 1000}) {
    const LightChoice choice(powers_of(lights, lights));
    for (std::size_t light = 0; light < lights; ++light)
      for (const double u : {0., 0x1p-53, 0.25, 0.5, 1 - 0x1p-53}) {
        const double number = choice.number(light, u);
        EXPECT_TRUE(number >= 0 && number < 1) << number;
        // The faintest may have no number of their own.
        if (choice.probability(light) < 0x1p-40) continue;
        EXPECT_EQ(choice(number), light) << u;
      }
  }
}

// Where a number and that of another light differ by a part of the interval, so do they on it.
TEST(LightChoice, SpreadsNumbersEvenlyOverTheInterval) {
  const LightChoice choice(std::vector{1., 5., 2.});
  EXPECT_EQ(choice.number(0, 0.5), 0.0625);
  EXPECT_EQ(choice.number(1, 0.2), 0.25);
  EXPECT_EQ(choice.number(2, 0.5), 0.875);
}

}  // namespace
}  // namespace wander::test::light_choice_test
