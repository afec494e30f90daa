#include "tests/support/films.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace wander::test {

namespace {

// t = (x - y) / √(a + b),  ν = (a + b)² / (a²/ν_x + b²/ν_y),  a and b the squared standard errors.
struct WelchOfBin {
  double t = 0, p_value = 0;
};
WelchOfBin welch_of_bin(const FilmEstimate& x, const FilmEstimate& y, std::size_t bin) {
  const double a = x.standard_error[bin] * x.standard_error[bin];
  const double b = y.standard_error[bin] * y.standard_error[bin];
  const double t = (x.value[bin] - y.value[bin]) / std::sqrt(a + b);
  if (!std::isfinite(t)) return {t, 0};
  const double degrees =
      (a + b) * (a + b) / (a * a / x.degrees_of_freedom + b * b / y.degrees_of_freedom);
  const boost::math::students_t distribution{degrees};
  return {t, 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)))};
}

}  // namespace

Decision films_agree(const FilmEstimate& a, const FilmEstimate& b, double false_alarm) {
  Decision decision{.test = "films agree", .false_alarm = false_alarm, .comparisons = 0};
  for (std::size_t bin = 0; bin < a.value.size(); ++bin) {
    if (!a.reliable[bin] || !b.reliable[bin]) continue;
    ++decision.comparisons;
    const WelchOfBin w = welch_of_bin(a, b, bin);
    if (decision.comparisons > 1 && w.p_value >= decision.p_value) continue;
    decision.p_value = w.p_value;
    decision.statistic = w.t;
    decision.worst = bin;
  }
  if (decision.comparisons == 0) {
    decision.detail = "no bin is reliable in both";
    return decision;
  }
  decision.passed = decision.p_value >= sidak_rate(false_alarm, decision.comparisons);
  return decision;
}

}  // namespace wander::test
