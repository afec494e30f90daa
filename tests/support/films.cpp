#include "tests/support/films.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "statistics/median.h"
#include "statistics/visible_error.h"

namespace wander::test {

namespace {

// t = (x - y) / √(a + b),  ν = (a + b)² / (a²/ν_x + b²/ν_y),  a and b the squared standard errors.
struct WelchOfBin {
  double t = 0, p_value = 0;
  double error = 0, degrees = 0;  // of the difference
};
WelchOfBin welch_of_bin(const FilmEstimate& x, const FilmEstimate& y, std::size_t bin) {
  const double a = x.standard_error[bin] * x.standard_error[bin];
  const double b = y.standard_error[bin] * y.standard_error[bin];
  const double error = std::sqrt(a + b), t = (x.value[bin] - y.value[bin]) / error;
  if (!std::isfinite(t)) return {t, 0};
  const double degrees =
      (a + b) * (a + b) / (a * a / x.degrees_of_freedom + b * b / y.degrees_of_freedom);
  const boost::math::students_t distribution{degrees};
  return {t, 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(t))), error,
          degrees};
}

}  // namespace

Decision films_agree(const FilmEstimate& a, const FilmEstimate& b, double false_alarm) {
  Decision decision{.test = "films agree", .false_alarm = false_alarm, .comparisons = 0};
  std::vector<WelchOfBin> compared;
  std::vector<double> sizes;
  for (std::size_t bin = 0; bin < a.value.size(); ++bin) {
    if (!a.reliable[bin] || !b.reliable[bin]) continue;
    ++decision.comparisons;
    const WelchOfBin w = welch_of_bin(a, b, bin);
    compared.push_back(w);
    sizes.push_back(std::abs(b.value[bin]));
    if (decision.comparisons > 1 && w.p_value >= decision.p_value) continue;
    decision.p_value = w.p_value;
    decision.statistic = w.t;
    decision.worst = bin;
  }
  if (decision.comparisons == 0) {
    decision.detail = "no bin is reliable in both";
    return decision;
  }
  const double rate = sidak_rate(false_alarm, decision.comparisons);
  decision.passed = decision.p_value >= rate;
  std::vector<double> visible;
  for (std::size_t i = 0; i < compared.size(); ++i)
    if (compared[i].error > 0 && sizes[i] > 0)
      visible.push_back(visible_difference(compared[i].error, compared[i].degrees, rate) /
                        sizes[i]);
  decision.visible = median(visible);
  return decision;
}

}  // namespace wander::test
