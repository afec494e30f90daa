// Statistical decisions with a stated false-alarm rate.
//
// Every decision takes the probability with which it may reject what is right, for the whole family
// of comparisons that it makes, and says how near it came.  A family rate α of m comparisons
// becomes a rate of each by Šidák, 1 - (1 - α)^(1/m).  A statistic that is not finite never passes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace wander {

// Count, mean and Σ (x - mean)² of a stream [Welford 1962]; streams merge [Chan et al. 1979].
class Moments {
 public:
  Moments() = default;
  explicit Moments(std::span<const double> values);

  void add(double value);
  void merge(const Moments& other);

  std::uint64_t count() const { return count_; }
  double mean() const { return mean_; }
  double variance() const;        // of one value, unbiased
  double standard_error() const;  // of the mean

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0, squares_ = 0;
};

struct Decision {
  std::string test;  // what was tested, in words
  bool passed = false;
  double statistic = 0;  // z, t, or Pearson's sum, as `test` says
  double threshold = 0;  // of the statistic
  double p_value = 1;    // of the worst comparison alone
  double false_alarm = 0;
  std::size_t comparisons = 1;
  std::size_t worst = 0;  // index of the worst comparison or cell
  // What half of the comparisons would have shown, relative to what they compare (visible_error.h); NaN if
  // that is not known.
  double visible = std::numeric_limits<double>::quiet_NaN();
  std::string detail{};  // why it failed, if not by the statistic; numbers worth reading

  explicit operator bool() const { return passed; }
};

// P(|Z| >= |z|); what is not a number gets 0, so that it is rejected.
double normal_two_sided_p(double z);
double sidak_rate(double family_false_alarm, std::size_t comparisons);
// |z| above this rejects one of so many two-sided comparisons.
double sidak_threshold(double family_false_alarm, std::size_t comparisons);
double student_two_sided_p(double t, double degrees);
double student_threshold(double false_alarm, double degrees);

// difference / error, where 0/0 is agreement without any spread and x/0 an infinite deviation.
double standardized(double difference, double error);

// An estimate whose standard error has so many degrees of freedom.
struct Measurement {
  double value, standard_error, degrees;
};
// t = (x - y) / √(a + b),  ν = (a + b)² / (a²/ν_x + b²/ν_y),  a, b = standard errors squared.
struct Welch {
  double t, degrees;
};
Welch welch(const Measurement& x, const Measurement& y);

// Many comparisons, one decision: the largest |z| against Šidák's threshold.
Decision largest_z_test(std::span<const double> z, double false_alarm);
// Equal values, unequal variances [Welch 1947]: the smallest p against Šidák's rate.
Decision welch_tests(std::span<const Measurement> a, std::span<const Measurement> b,
                     double false_alarm);

// Throws unless both sides of a family hold the same number of values, and at least one.
void require_family(std::size_t a, std::size_t b);

}  // namespace wander
