#include "tests/support/statistics.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "statistics/median.h"
#include "statistics/visible_error.h"

namespace wander::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The two-sided decision that all tests on Student's distribution share, of a difference with this
// standard error and relative to `level`.
Decision student_decision(std::string test, double t, double degrees, double error, double level,
                          double false_alarm) {
  Decision d{.test = std::move(test), .statistic = t, .false_alarm = false_alarm};
  d.visible = visible_difference(error, degrees, false_alarm) / std::abs(level);
  d.threshold = student_threshold(false_alarm, degrees);
  d.p_value = student_two_sided_p(t, degrees);
  d.passed = std::abs(t) <= d.threshold;
  d.detail = std::to_string(degrees) + " degrees of freedom";
  return d;
}

Measurement measurement(const Moments& x) {
  if (x.count() < 2) throw std::invalid_argument("a Welch test needs two values on each side");
  return {x.mean(), x.standard_error(), static_cast<double>(x.count() - 1)};
}

std::vector<Measurement> measurements(std::span<const Moments> bins) {
  std::vector<Measurement> all;
  for (const Moments& bin : bins) all.push_back(measurement(bin));
  return all;
}

}  // namespace

double bonferroni_threshold(double family_false_alarm, std::size_t comparisons) {
  return sidak_threshold(family_false_alarm / static_cast<double>(comparisons), 1);
}

std::ostream& operator<<(std::ostream& out, const Decision& d) {
  out << d.test << (d.passed ? " passed" : " FAILED") << ": statistic " << d.statistic
      << ", threshold " << d.threshold << ", p = " << d.p_value << ", false-alarm rate "
      << d.false_alarm;
  if (d.comparisons > 1) out << ", worst of " << d.comparisons << ": number " << d.worst;
  if (!d.detail.empty()) out << "; " << d.detail;
  return out;
}

std::string describe(const Decision& decision) {
  std::ostringstream text;
  text << decision;
  return text.str();
}

Decision z_test(double estimate, double standard_error, double exact, double false_alarm) {
  Decision d{.test = "z test of one mean", .false_alarm = false_alarm};
  d.statistic = standardized(estimate - exact, standard_error);
  d.threshold = sidak_threshold(false_alarm, 1);
  d.p_value = normal_two_sided_p(d.statistic);
  d.visible = visible_normal(standard_error, d.threshold) / std::abs(exact);
  // An infinite error would turn every deviation into z = 0.
  d.passed = std::isfinite(standard_error) && std::abs(d.statistic) <= d.threshold;
  std::ostringstream text;
  text << "estimate " << estimate << " ± " << standard_error << ", exact " << exact;
  d.detail = text.str();
  return d;
}

Decision z_test(const Moments& sample, double exact, double false_alarm) {
  return z_test(sample.mean(), sample.standard_error(), exact, false_alarm);
}

Decision t_test(const Moments& sample, double exact, double false_alarm) {
  if (sample.count() < 2) throw std::invalid_argument("a t test needs two values");
  const double t = standardized(sample.mean() - exact, sample.standard_error());
  return student_decision("t test of one mean", t, static_cast<double>(sample.count() - 1),
                          sample.standard_error(), exact, false_alarm);
}

Decision paired_t_test(std::span<const double> a, std::span<const double> b, double false_alarm) {
  require_family(a.size(), b.size());
  Moments differences, level;
  for (std::size_t i = 0; i < a.size(); ++i) {
    differences.add(a[i] - b[i]);
    level.add(b[i]);
  }
  if (differences.count() < 2) throw std::invalid_argument("a paired test needs two pairs");
  const auto degrees = static_cast<double>(differences.count() - 1);
  const double error = differences.standard_error();
  return student_decision("paired t test", standardized(differences.mean(), error), degrees, error,
                          level.mean(), false_alarm);
}

Decision welch_test(const Moments& a, const Moments& b, double false_alarm) {
  const Welch w = welch(measurement(a), measurement(b));
  const double error = std::hypot(a.standard_error(), b.standard_error());
  return student_decision("Welch test of two means", w.t, w.degrees, error, b.mean(), false_alarm);
}

double welch_p_value(const Moments& a, const Moments& b) {
  const Welch w = welch(measurement(a), measurement(b));
  return student_two_sided_p(w.t, w.degrees);
}

Decision largest_z_test(std::span<const Compared> family, double false_alarm) {
  std::vector<double> z, visible;
  for (const Compared& one : family) z.push_back(one.z);
  Decision d = wander::largest_z_test(z, false_alarm);
  for (const Compared& one : family)
    if (one.standard_error > 0 && one.size > 0 && std::isfinite(one.size))
      visible.push_back(visible_normal(one.standard_error, d.threshold) / one.size);
  d.visible = median(visible);
  return d;
}

Decision bins_z_test(std::span<const Moments> bins, std::span<const double> exact,
                     double false_alarm, std::span<const double> sizes) {
  require_family(bins.size(), exact.size());
  if (!sizes.empty()) require_family(bins.size(), sizes.size());
  std::vector<Compared> family;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double error = bins[i].standard_error();
    // Without two values there is no error bar, hence no agreement.
    const double z =
        std::isfinite(error) ? standardized(bins[i].mean() - exact[i], error) : infinity;
    family.push_back({z, error, std::abs(sizes.empty() ? exact[i] : sizes[i])});
  }
  Decision d = largest_z_test(family, false_alarm);
  std::ostringstream text;
  text << "there " << bins[d.worst].mean() << " ± " << bins[d.worst].standard_error() << ", exact "
       << exact[d.worst];
  d.detail = text.str();
  return d;
}

Decision bins_welch_test(std::span<const Moments> a, std::span<const Moments> b,
                         double false_alarm) {
  return welch_tests(measurements(a), measurements(b), false_alarm);
}

// Quantiles of the beta distributions that the binomial tails are.
ConfidenceInterval binomial_interval(std::uint64_t successes, std::uint64_t trials,
                                     double confidence) {
  using boost::math::beta_distribution;
  using boost::math::complement;
  using boost::math::quantile;
  const double tail = (1 - confidence) / 2;
  const auto k = static_cast<double>(successes), n = static_cast<double>(trials);
  ConfidenceInterval interval;
  if (successes > 0) interval.low = quantile(beta_distribution<>{k, n - k + 1}, tail);
  if (successes < trials)
    interval.high = quantile(complement(beta_distribution<>{k + 1, n - k}, tail));
  return interval;
}

// Two-sided, p = 2 min(P(X <= k), P(X >= k)); the interval is for the reader of a failure.
Decision binomial_test(std::uint64_t successes, std::uint64_t trials, double probability,
                       double false_alarm) {
  if (trials == 0 || successes > trials)
    throw std::invalid_argument("a binomial test needs 0 < trials and successes <= trials");
  Decision d{.test = "binomial test of a proportion", .false_alarm = false_alarm};
  const boost::math::binomial distribution{static_cast<double>(trials), probability};
  const auto k = static_cast<double>(successes);
  const double below = boost::math::cdf(distribution, k);  // P(X <= k)
  const double above =
      successes == 0 ? 1 : boost::math::cdf(boost::math::complement(distribution, k - 1));
  d.statistic = k / static_cast<double>(trials);
  d.threshold = probability;
  d.p_value = std::min(1.0, 2 * std::min(below, above));
  d.passed = d.p_value >= false_alarm;
  const double error = std::sqrt(probability * (1 - probability) / static_cast<double>(trials));
  d.visible = visible_normal(error, sidak_threshold(false_alarm, 1)) / probability;
  const ConfidenceInterval interval = binomial_interval(successes, trials, 1 - false_alarm);
  std::ostringstream text;
  text << successes << " of " << trials << ", interval [" << interval.low << ", " << interval.high
       << "] for the probability " << probability;
  d.detail = text.str();
  return d;
}

}  // namespace wander::test
