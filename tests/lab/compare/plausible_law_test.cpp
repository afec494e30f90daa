// Draws of the mean of a skewed quantity follow the law that plausible.h states, which is integrated
// here: the weight of each shape by the midpoint rule over log a, the rest in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "lab/compare/plausible.h"
#include "tests/support/statistics.h"

namespace wander::test::plausible_law_test {
namespace {

// P(log(E D / D̄) <= x) of replicates, with numbers that a twin can change.
class Law {
 public:
  struct Numbers {
    double stretch = 1.15, tempering = 0.5, student = 1.0 / 3;
  };

  Law(const std::vector<double>& values, const Numbers& numbers)
      : stretch_(numbers.stretch), tempering_(numbers.tempering), student_(numbers.student) {
    count_ = static_cast<double>(values.size());
    mean_ = std::accumulate(values.begin(), values.end(), 0.0) / count_;
    for (const double v : values) mean_log_ += std::log(v) / count_;
    for (const double v : values) {
      log_squares_ += std::pow(std::log(v) - mean_log_, 2);
      squares_ += std::pow(v - mean_, 2);
    }
    weigh_shapes();
  }

  double quantile(double p) const {
    double low = -10, high = 10;
    for (int i = 0; i < 40; ++i) (at((low + high) / 2) < p ? low : high) = (low + high) / 2;
    return (low + high) / 2;
  }

 private:
  double at(double x) const {
    const double t = x / stretch_ / (std::sqrt(squares_ / (count_ - 1) / count_) / mean_);
    return student_ * cdf(boost::math::students_t(count_ - 1), t) +
           (1 - student_) * of_shapes(x / stretch_);
  }
  double log_gm() const { return mean_log_ - std::log(mean_); }
  static double spread(double a) { return std::min(std::sqrt(boost::math::trigamma(a)), 1.5); }

  // The logarithms of p(a | D) a of both laws, in one unit.
  double log_gamma_weight(double a) const {
    return count_ * a * (log_gm() - std::log(count_)) - count_ * std::lgamma(a) +
           std::lgamma(count_ * a);
  }
  double log_lognormal_weight(double a) const {
    const double sigma = spread(a);
    return -(count_ - 1) * std::log(sigma) - log_squares_ / 2 / sigma / sigma -
           std::log(count_) / 2 - (count_ - 1) / 2 * std::log(2 * std::numbers::pi);
  }
  double of_shapes(double x) const {
    double below = 0;
    for (const Shape& shape : shapes_) {
      const double a = shape.a * count_, sigma = spread(shape.a);
      // log(R a / G) <= x where G >= R a e^-x.
      if (shape.gamma > negligible)
        below +=
            shape.gamma * cdf(complement(boost::math::gamma_distribution(a), a * std::exp(-x)));
      if (shape.lognormal > negligible)
        below += shape.lognormal * cdf(boost::math::normal(), (x - log_gm() - sigma * sigma / 2) *
                                                                  std::sqrt(count_) / sigma);
    }
    return below;
  }

  struct Shape {
    double a, gamma, lognormal;  // weights
  };
  void weigh_shapes() {
    constexpr int steps = 400;
    // The program's shapes are 60, from 0.25 to 1e7: half a step more on either side.
    const double low = std::log(0.25), step = std::log(1e7 / 0.25) / 59;
    double top = -std::numeric_limits<double>::infinity(), sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double a = std::exp(low - step / 2 + 60 * step * (i + 0.5) / steps);
      shapes_.push_back({a, log_gamma_weight(a), log_lognormal_weight(a)});
      top = std::max({top, shapes_.back().gamma, shapes_.back().lognormal});
    }
    for (Shape& shape : shapes_) {
      shape.gamma = std::exp(tempering_ * (shape.gamma - top));
      shape.lognormal = std::exp(tempering_ * (shape.lognormal - top));
      sum += shape.gamma + shape.lognormal;
    }
    for (Shape& shape : shapes_) {
      shape.gamma /= sum;
      shape.lognormal /= sum;
    }
  }

  static constexpr double negligible = 1e-12;
  double stretch_, tempering_, student_;
  std::vector<Shape> shapes_;
  double count_ = 0, mean_ = 0, mean_log_ = 0, squares_ = 0, log_squares_ = 0;
};

const std::vector<std::vector<double>> cases{
    {0.4, 1.7, 0.9}, {1.1, 0.93, 1.02, 0.97}, {0.02, 0.5, 3.1, 0.7, 1.2, 0.3, 0.09, 2}};

// Draws in cells of the same probability.
Decision follow(const std::vector<double>& values, const Law::Numbers& numbers) {
  constexpr std::uint32_t streams = 4;
  constexpr std::size_t cells = 20;
  const Law law(values, numbers);
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  std::vector<double> edges;
  for (std::size_t i = 1; i < cells; ++i)
    edges.push_back(mean * std::exp(law.quantile(static_cast<double>(i) / cells)));
  std::vector<double> counts(cells, 0);
  for (std::uint32_t stream = 0; stream < streams; ++stream)
    for (const double draw : compare::draws_of_mean(values, stream))
      ++counts[static_cast<std::size_t>(std::ranges::upper_bound(edges, draw) - edges.begin())];
  const double each = static_cast<double>(streams * compare::draw_count) / cells;
  return chi_square_test(counts, std::vector<double>(cells, each), usual_false_alarm / 3);
}

TEST(PlausibleLaw, IsThatOfTheDraws) {
  for (const auto& values : cases) EXPECT_TRUE(follow(values, {}));
}

// Intervals a tenth longer or shorter, of evidence that counts whole, and of other shares.
TEST(PlausibleLaw, OtherNumbersAreCaught) {
  for (const auto& values : cases) {
    EXPECT_FALSE(follow(values, {.stretch = 1.15 * 1.1}));
    EXPECT_FALSE(follow(values, {.stretch = 1.15 * 0.9}));
  }
  EXPECT_FALSE(follow(cases[1], {.tempering = 1}));
  EXPECT_FALSE(follow(cases[2], {.student = 0.5}));
}

}  // namespace
}  // namespace wander::test::plausible_law_test
