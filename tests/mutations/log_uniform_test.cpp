// Log-uniform distances: their logarithm is uniform, their density is the one that is stated, and
// they keep to their range.  False-alarm rate 1e-9 per χ².
#include "mutations/log_uniform.h"

#include <gtest/gtest.h>

#include "core/rng.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"

namespace wander::test {
namespace {

struct Fixed {
  double number;
  double uniform() { return number; }
};

constexpr LogUniform range{1e-4, 0.1};
constexpr std::size_t cells = 30;

// Whether draws fill cells of equal ratio as `density` says.
template <class Draw, class Density>
Decision fills_cells(const Draw& draw, const Density& density) {
  const double ratio = std::log(range.largest / range.smallest);
  std::vector<double> observed(cells), expected(cells);
  Rng random(3, Purpose::test, 66);
  constexpr int draws = 100'000;
  for (int i = 0; i < draws; ++i) {
    const double part = std::log(draw(random) / range.smallest) / ratio;
    ++observed[static_cast<std::size_t>(std::clamp(part, 0.0, 0.999999999) * cells)];
  }
  for (std::size_t i = 0; i < cells; ++i) {
    const auto at = [&](std::size_t k) {
      return range.smallest * std::exp(ratio * static_cast<double>(k) / cells);
    };
    expected[i] = draws * integral(density, at(i), at(i + 1));
  }
  return chi_square_test(observed, expected, usual_false_alarm);
}

// The density as the draw of that distance states it.
double stated_density(double distance) {
  const double ratio = std::log(range.largest / range.smallest);
  Fixed number{std::log(range.largest / distance) / ratio};
  return range.draw(number).density;
}

TEST(LogUniformDistances, HaveTheDensityThatIsStated) {
  const auto draw = [](Rng& random) { return range.draw(random).value; };
  EXPECT_NEAR(integral(stated_density, range.smallest, range.largest, {.absolute = 1e-11}), 1,
              1e-9);
  EXPECT_TRUE(passes(fills_cells(draw, stated_density)));
  // Control: a density without its 1/d.
  const auto even = [](double) { return 1 / (range.largest - range.smallest); };
  EXPECT_TRUE(rejects(fills_cells(draw, even)));
}

TEST(LogUniformDistances, KeepToTheirRange) {
  Fixed none{0}, nearly_one{std::nextafter(1.0, 0.0)};
  EXPECT_EQ(range.draw(none).value, range.largest);
  EXPECT_NEAR(range.draw(nearly_one).value / range.smallest, 1, 1e-12);
}

}  // namespace
}  // namespace wander::test
