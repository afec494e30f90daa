// The least squares of two films recounted from their definition: three bins, eight groups of unequal samples, each
// minimum by Brent's method, and what is left out by films that are summed anew.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

#include "mlt/run/film_fit.h"
#include "tests/support/generator.h"

namespace wander::test::film_fit_recount_test {
namespace {

constexpr std::size_t groups = 8, bins = 3;

std::vector<FilmFitGroup> made() {
  Generator random(3);
  std::vector<FilmFitGroup> data;
  for (std::size_t g = 0; g < groups; ++g) {
    FilmFitGroup group{{}, 50 + 10.0 * static_cast<double>(g), {}};
    for (std::size_t j = 0; j < bins; ++j) {
      const double brightness = 1 + static_cast<double>(j);
      group.found.push_back(group.samples * brightness * (0.4 + random.uniform()));
      group.deposits.push_back(brightness * (0.2 + 1.6 * random.uniform()));
    }
    data.push_back(group);
  }
  return data;
}

using Left = std::set<std::size_t>;  // groups that are left out
using Film = std::array<double, bins>;

class Recount {
 public:
  explicit Recount(std::vector<FilmFitGroup> data) : data_(std::move(data)) {}

  double b(const Left& left) const { return (half(0, left) + half(1, left)) / 2; }
  double chi2_per_degree() const {
    const double sum = squares(0, half(0, {}), {}) + squares(1, half(1, {}), {});
    return sum / (2 * (bins - 1));
  }

 private:
  double half(std::size_t parity, const Left& left) const {
    const auto function = [&](double b) { return squares(parity, b, left); };
    return boost::math::tools::brent_find_minima(function, 0.5, 50.0, 50).first;
  }
  // Σ (I_j - b p_j)²/(v_j + b² Var p_j); the variances are those of all groups.
  double squares(std::size_t parity, double b, const Left& left) const {
    const Film film = found(parity, left), p = shape(left);
    const double noise = variance_of_found(1 - parity), of_shape = variance_of_shape();
    double sum = 0;
    for (std::size_t j = 0; j < bins; ++j)
      sum += std::pow(film[j] - b * p[j], 2) / (noise + b * b * of_shape);
    return sum;
  }
  // Of the groups of one half.
  Film found(std::size_t parity, const Left& left) const {
    Film film{};
    double samples = 0;
    for (std::size_t g = parity; g < groups; g += 2) {
      if (left.contains(g)) continue;
      samples += data_[g].samples;
      for (std::size_t j = 0; j < bins; ++j) film[j] += data_[g].found[j] * bins;
    }
    for (double& value : film) value /= samples;
    return film;
  }
  // Of mean one, of the chains of both halves.
  Film shape(const Left& left) const {
    Film film{};
    double mass = 0;
    for (std::size_t g = 0; g < groups; ++g)
      for (std::size_t j = 0; j < bins; ++j) {
        if (left.contains(g)) continue;
        film[j] += data_[g].deposits[j] * bins;
        mass += data_[g].deposits[j];
      }
    for (double& value : film) value /= mass;
    return film;
  }
  // Of a half's film, from the spread of its groups; of three bins each lies within two of the others, and
  // all have the mean.
  double variance_of_found(std::size_t parity) const {
    const Film mean = found(parity, {});
    const double count = groups / 2.0;
    double sum = 0;
    for (std::size_t g = parity; g < groups; g += 2)
      for (std::size_t j = 0; j < bins; ++j)
        sum += std::pow(data_[g].found[j] * bins / data_[g].samples - mean[j], 2);
    return sum / (count * (count - 1)) / bins;
  }
  double variance_of_shape() const {
    const Film whole = shape({});
    double sum = 0;
    for (std::size_t g = 0; g < groups; ++g)
      for (std::size_t j = 0; j < bins; ++j) sum += std::pow(shape({g})[j] - whole[j], 2);
    return sum * (groups - 1) / groups / bins;
  }

  std::vector<FilmFitGroup> data_;
};

// θ_(g), drawn towards their mean by what Efron and Stein's products of two groups add: Σ_{g<h} Q_gh²/G², told by
// pairs whose numbers are 1 or 3 apart.
std::vector<double> expected_without(const Recount& recount) {
  const double n = groups, all = recount.b({});
  std::vector<double> without;
  double mean = 0, variance = 0, products = 0, pairs = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    without.push_back(recount.b({g}));
    mean += without[g] / n;
  }
  for (const double value : without) variance += (n - 1) / n * std::pow(value - mean, 2);
  for (const std::size_t apart : {1, 3})
    for (std::size_t g = 0; g < groups; ++g, ++pairs) {
      const std::size_t h = (g + apart) % groups;
      const double q = n * all - (n - 1) * (without[g] + without[h]) + (n - 2) * recount.b({g, h});
      products += q * q;
    }
  const double once = products / pairs * (n * (n - 1) / 2) / (n * n);
  for (double& value : without) value = mean + std::sqrt(1 - once / variance) * (value - mean);
  return without;
}

TEST(FilmFitRecount, IsWhatItsDefinitionGives) {
  const std::vector<FilmFitGroup> data = made();
  const FilmFit fit = fit_films(data, std::array{static_cast<int>(bins)});
  const Recount recount(data);
  ASSERT_TRUE(fit.failure.empty()) << fit.failure;
  EXPECT_NEAR(fit.b, recount.b({}), 1e-6);
  EXPECT_NEAR(fit.chi2_per_degree, recount.chi2_per_degree(), 1e-6);
  const std::vector<double> expected = expected_without(recount);
  ASSERT_EQ(fit.without.size(), groups);
  double correction = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    EXPECT_NEAR(fit.without[g], expected[g], 1e-5) << g;
    correction = std::max(correction, std::abs(recount.b({g}) - expected[g]));
  }
  EXPECT_GT(correction, 1e-4) << "the case would not show whether products count once or twice";
}

}  // namespace
}  // namespace wander::test::film_fit_recount_test
