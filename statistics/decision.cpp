#include "statistics/decision.h"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "statistics/median.h"
#include "statistics/number_text.h"
#include "statistics/visible_error.h"

namespace wander {

Moments::Moments(std::span<const double> values) {
  for (const double value : values) add(value);
}

void Moments::add(double value) {
  ++count_;
  const double before = value - mean_;
  mean_ += before / static_cast<double>(count_);
  squares_ += before * (value - mean_);
}

// With δ the difference of the means: Σ² = Σ₁² + Σ₂² + δ² n m / (n + m).
void Moments::merge(const Moments& other) {
  if (other.count_ == 0) return;
  const auto n = static_cast<double>(count_), m = static_cast<double>(other.count_);
  const double difference = other.mean_ - mean_;
  mean_ += difference * (m / (n + m));
  squares_ += other.squares_ + difference * difference * (n * m / (n + m));
  count_ += other.count_;
}

double Moments::variance() const {
  return count_ < 2 ? 0 : squares_ / static_cast<double>(count_ - 1);
}

double Moments::standard_error() const {
  return count_ < 2 ? std::numeric_limits<double>::infinity()
                    : std::sqrt(variance() / static_cast<double>(count_));
}

double normal_two_sided_p(double z) {
  if (std::isnan(z)) return 0;
  return std::erfc(std::abs(z) / std::sqrt(2.0));
}

// 1 - (1 - α)^(1/m), without the cancellation that α = 1e-7 would meet.
double sidak_rate(double family_false_alarm, std::size_t comparisons) {
  return -std::expm1(std::log1p(-family_false_alarm) / static_cast<double>(comparisons));
}

double sidak_threshold(double family_false_alarm, std::size_t comparisons) {
  const double rate = sidak_rate(family_false_alarm, comparisons);
  return boost::math::quantile(boost::math::complement(boost::math::normal{}, rate / 2));
}

namespace {

// Quantiles that no double holds are infinite.
using StudentsT = boost::math::students_t_distribution<
    double, boost::math::policies::policy<
                boost::math::policies::overflow_error<boost::math::policies::ignore_error>>>;
// With so few degrees of freedom hardly any t is evidence, and Boost has no quantiles.
constexpr double fewest_degrees = 1e-2;

}  // namespace

double student_two_sided_p(double t, double degrees) {
  if (!std::isfinite(t)) return 0;
  if (degrees < fewest_degrees) return 1;
  const StudentsT distribution{degrees};
  return 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

double student_threshold(double false_alarm, double degrees) {
  if (degrees < fewest_degrees) return std::numeric_limits<double>::infinity();
  const StudentsT distribution{degrees};
  return boost::math::quantile(boost::math::complement(distribution, false_alarm / 2));
}

double standardized(double difference, double error) {
  return difference == 0 && error == 0 ? 0 : difference / error;
}

Welch welch(const Measurement& x, const Measurement& y) {
  const double a = x.standard_error * x.standard_error, b = y.standard_error * y.standard_error;
  const double t = standardized(x.value - y.value, std::sqrt(a + b));
  const double spread = a * a / x.degrees + b * b / y.degrees;
  return {t, spread > 0 ? (a + b) * (a + b) / spread : x.degrees + y.degrees};
}

void require_family(std::size_t a, std::size_t b) {
  if (a == 0) throw std::invalid_argument("an empty family of comparisons decides nothing");
  if (a != b) throw std::invalid_argument("a family needs as many values on each side");
}

Decision largest_z_test(std::span<const double> z, double false_alarm) {
  require_family(z.size(), z.size());
  Decision d{.test = "largest |z|", .passed = true, .false_alarm = false_alarm};
  d.comparisons = z.size();
  d.threshold = sidak_threshold(false_alarm, z.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (std::abs(z[i]) <= std::abs(d.statistic)) continue;
    d.statistic = z[i];  // a NaN lands here too, and no later value displaces it
    d.worst = i;
    if (std::isnan(z[i])) break;
  }
  d.p_value = normal_two_sided_p(d.statistic);
  d.passed = std::abs(d.statistic) <= d.threshold;
  return d;
}

namespace {

std::string text_of(const Measurement& m) {
  return fmt::format("{} ± {}", number_text(m.value, 6), number_text(m.standard_error, 2));
}

}  // namespace

Decision welch_tests(std::span<const Measurement> a, std::span<const Measurement> b,
                     double false_alarm) {
  require_family(a.size(), b.size());
  Decision d{.test = "Welch test of each bin",
             .p_value = std::numeric_limits<double>::infinity(),
             .false_alarm = false_alarm};
  d.comparisons = a.size();
  const double rate = sidak_rate(false_alarm, a.size());
  std::vector<double> visible;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Welch w = welch(a[i], b[i]);
    const double error = std::hypot(a[i].standard_error, b[i].standard_error);
    visible.push_back(visible_difference(error, w.degrees, rate) / std::abs(b[i].value));
    const double p = student_two_sided_p(w.t, w.degrees);
    if (p >= d.p_value) continue;
    d.p_value = p;
    d.worst = i;
    d.statistic = w.t;
    d.threshold = student_threshold(rate, w.degrees);
  }
  d.passed = d.p_value >= rate;
  d.visible = median(visible);
  d.detail = fmt::format("there {} against {}", text_of(a[d.worst]), text_of(b[d.worst]));
  return d;
}

}  // namespace wander
