#include "mlt/watch/diagnostics.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "mlt/watch/chains_record.h"

namespace wander {

namespace {

constexpr std::size_t fewest_draws = 4;

bool tell_something(const Draws& x) {
  if (x.chains < 1 || x.length < fewest_draws) return false;
  if (!std::ranges::all_of(x.values, [](double v) { return std::isfinite(v); })) return false;
  return std::ranges::any_of(x.values, [&](double v) { return v != x.values.front(); });
}

// About the first value, so that values that are all the same have no variance.
double mean_of(const double* x, std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += x[i] - x[0];
  return x[0] + sum / static_cast<double>(n);
}
double mean_of(const std::vector<double>& x) { return mean_of(x.data(), x.size()); }

// Σ (x - mean)² / (n - 1).
double variance_of(const double* x, std::size_t n) {
  const double mean = mean_of(x, n);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (x[i] - mean) * (x[i] - mean);
  return sum / static_cast<double>(n - 1);
}
double variance_of(const std::vector<double>& x) { return variance_of(x.data(), x.size()); }

template <class F>
Draws mapped(Draws x, F&& f) {
  for (double& v : x.values) v = f(v);
  return x;
}

// The first and the last half of each chain; of an odd number of draws the middle one is left out.
Draws split(const Draws& x) {
  const std::size_t half = x.length / 2;
  Draws halves{2 * x.chains, half, {}};
  halves.values.reserve(halves.chains * half);
  for (const std::size_t start : {std::size_t{0}, x.length - half})
    for (std::size_t c = 0; c < x.chains; ++c)
      halves.values.insert(halves.values.end(), x.chain(c) + start, x.chain(c) + start + half);
  return halves;
}

// Quantile by linear interpolation, type 7 of Hyndman and Fan (1996).
double quantile(std::vector<double> x, double probability) {
  const double n = static_cast<double>(x.size()), place = n * probability + (1 - probability);
  const double below = std::floor(std::clamp(place, 1.0, n - 1));
  const double share = std::clamp(place - below, 0.0, 1.0);
  const auto upper = x.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(x.begin(), upper, x.end());
  const double low = *std::max_element(x.begin(), upper), high = *upper;
  return low == high ? low : (1 - share) * low + share * high;
}

// An integer that is the greater the greater x is, and the same for zeros of both signs: its bits, those of negative
// numbers turned.  The sort relies on it, and writes anywhere if it is not so.
std::uint64_t ordered_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);  // -0 + 0 is 0
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return bits & sign ? ~bits : bits | sign;
}

// Values with their places, the smallest first.
std::vector<std::pair<double, std::size_t>> sorted_places(const std::vector<double>& x) {
  using Placed = std::pair<double, std::size_t>;
  std::vector<Placed> sorted(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sorted[i] = {x[i], i};
  boost::sort::spreadsort::integer_sort(
      sorted.begin(), sorted.end(),
      [](const Placed& one, unsigned bits) { return ordered_bits(one.first) >> bits; },
      [](const Placed& one, const Placed& other) { return one.first < other.first; });
  return sorted;
}

// z = Φ⁻¹((rank - 3/8) / (S + 1/4)) [Blom 1958]; equal values share their mean rank.
Draws normal_scores(Draws x) {
  using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  const boost::math::normal_distribution<double, Policy> standard;
  const std::size_t size = x.values.size();
  const auto sorted = sorted_places(x.values);
  for (std::size_t first = 0, end = 0; first < size; first = end) {
    while (end < size && sorted[end].first == sorted[first].first) ++end;
    const double rank = static_cast<double>(first + 1 + end) / 2;
    const double z = boost::math::quantile(standard, (rank - 0.375) / (double(size) + 0.25));
    for (std::size_t i = first; i < end; ++i) x.values[sorted[i].second] = z;
  }
  return x;
}

Draws folded(const Draws& x) {
  return mapped(x, [median = quantile(x.values, 0.5)](double v) { return std::abs(v - median); });
}

std::vector<double> chain_means(const Draws& x) {
  std::vector<double> means;
  for (std::size_t c = 0; c < x.chains; ++c) means.push_back(mean_of(x.chain(c), x.length));
  return means;
}

double r_hat(const Draws& x) {
  std::vector<double> variances;
  for (std::size_t c = 0; c < x.chains; ++c) variances.push_back(variance_of(x.chain(c), x.length));
  const double n = static_cast<double>(x.length), within = mean_of(variances);
  return std::sqrt((n * variance_of(chain_means(x)) / within + n - 1) / n);
}

// Σ x_i y_i in several sums, which do not wait for each other.
double dot(const double* x, const double* y, std::size_t n) {
  constexpr std::size_t sums = 8;
  std::array<double, sums> part{};
  std::size_t i = 0;
  for (; i + sums <= n; i += sums)
    for (std::size_t k = 0; k < sums; ++k) part[k] += x[i + k] * y[i + k];
  for (; i < n; ++i) part[0] += x[i] * y[i];
  return std::accumulate(part.begin(), part.end(), 0.0);
}

// Autocovariances ĉ_t = Σ (x_i - mean)(x_{i+t} - mean) / N, the mean over chains.
class Autocovariance {
 public:
  explicit Autocovariance(Draws x) : centred_(std::move(x)), means_(chain_means(centred_)) {
    for (std::size_t i = 0; i < centred_.values.size(); ++i)
      centred_.values[i] -= means_[i / centred_.length];
  }
  double operator()(std::size_t lag) const {
    double sum = 0;
    for (std::size_t c = 0; c < centred_.chains; ++c)
      sum += dot(centred_.chain(c) + lag, centred_.chain(c), centred_.length - lag);
    return sum / static_cast<double>(centred_.values.size());
  }
  const std::vector<double>& means() const { return means_; }

 private:
  Draws centred_;
  std::vector<double> means_;
};

// ρ_t = 1 - (W - ĉ_t) / var⁺ of draws that are split.
class CombinedAutocorrelation {
 public:
  explicit CombinedAutocorrelation(const Draws& x) : covariance_(x) {
    const double n = static_cast<double>(x.length), biased = covariance_(0);
    within_ = biased * n / (n - 1);
    total_ = biased + (x.chains > 1 ? variance_of(covariance_.means()) : 0);
  }
  double operator()(std::size_t lag) const { return 1 - (within_ - covariance_(lag)) / total_; }

 private:
  Autocovariance covariance_;
  double within_, total_;
};

// ρ_t of Geyer's initial positive sequence, ρ_{2j} + ρ_{2j+1} > 0; behind it the first even one.
std::vector<double> positive_sequence(const Draws& x) {
  const CombinedAutocorrelation rho(x);
  double even = 1, odd = rho(1);
  std::vector<double> sequence;
  for (std::size_t t = 1; t + 3 < x.length && even + odd > 0; t += 2) {
    sequence.insert(sequence.end(), {even, odd});
    even = rho(t + 1);
    odd = rho(t + 2);
  }
  sequence.push_back(even + odd >= 0 ? even : std::max(even, 0.0));
  return sequence;
}

// τ = -1 + 2 Σ ρ_t, the sums of pairs made monotone; the even term behind the pairs counts once.
double geyer_time(const Draws& x) {
  std::vector<double> rho = positive_sequence(x);
  for (std::size_t t = 2; t + 1 < rho.size(); t += 2) {
    const double before = rho[t - 2] + rho[t - 1];
    if (rho[t] + rho[t + 1] > before) rho[t] = rho[t + 1] = before / 2;
  }
  const double tau = -1 + 2 * std::accumulate(rho.begin(), rho.end() - 1, 0.0) + rho.back();
  return std::max(tau, 1 / std::log10(static_cast<double>(x.values.size())));
}

// Of draws that are split.  What never changes is known as well as by independent draws.
double ess(const Draws& x) {
  const auto size = static_cast<double>(x.values.size());
  const auto [low, high] = std::ranges::minmax_element(x.values);
  return *low == *high ? size : size / geyer_time(x);
}

Draws squared_deviations(const Draws& x) {
  return mapped(x, [mean = mean_of(x.values)](double v) { return (v - mean) * (v - mean); });
}

}  // namespace

std::vector<double> combined_autocorrelation(const Draws& draws, std::size_t lags) {
  if (!tell_something(draws)) return {};
  const Draws halves = split(draws);
  const CombinedAutocorrelation rho(halves);
  std::vector<double> all{1};
  for (std::size_t lag = 1; lag <= std::min(lags, halves.length - 1); ++lag)
    all.push_back(rho(lag));
  return all;
}

double split_r_hat(const Draws& draws) {
  if (draws.chains < 2 || !tell_something(draws)) return not_known;
  return r_hat(split(draws));
}

double rank_r_hat(const Draws& draws) {
  if (draws.chains < 2 || !tell_something(draws)) return not_known;
  const Draws halves = split(draws);
  return std::fmax(r_hat(normal_scores(halves)), r_hat(normal_scores(folded(halves))));
}

double ess_mean(const Draws& draws) {
  return tell_something(draws) ? ess(split(draws)) : not_known;
}

double ess_sd(const Draws& draws) {
  return tell_something(draws) ? ess(split(squared_deviations(draws))) : not_known;
}

double ess_quantile(const Draws& draws, double probability) {
  if (!tell_something(draws)) return not_known;
  const double q = quantile(draws.values, probability);
  return ess(split(mapped(draws, [q](double v) { return v <= q ? 1.0 : 0.0; })));
}

double ess_bulk(const Draws& draws) {
  return tell_something(draws) ? ess(normal_scores(split(draws))) : not_known;
}

double ess_tail(const Draws& draws) {
  return std::min(ess_quantile(draws, 0.05), ess_quantile(draws, 0.95));
}

double mcse_mean(const Draws& draws) {
  if (!tell_something(draws)) return not_known;
  return std::sqrt(variance_of(draws.values) / ess_mean(draws));
}

// The variance of the second moment, carried to its root.
double mcse_sd(const Draws& draws) {
  if (!tell_something(draws)) return not_known;
  const Draws squares = squared_deviations(draws);
  const double second = mean_of(squares.values);
  const double fourth = mean_of(mapped(squares, [](double v) { return v * v; }).values);
  return std::sqrt((fourth - second * second) / ess_sd(draws) / second / 4);
}

// Half the distance of the quantiles that the 16 % and 84 % points of the quantile's rank reach.
double mcse_quantile(const Draws& draws, double probability) {
  if (!tell_something(draws)) return not_known;
  const double size = ess_quantile(draws, probability);
  const boost::math::beta_distribution<> rank(size * probability + 1, size * (1 - probability) + 1);
  std::vector<double> sorted = draws.values;
  std::ranges::sort(sorted);
  const double n = static_cast<double>(sorted.size());
  const double low = std::max(0.0, boost::math::quantile(rank, 0.1586553) * n - 1);
  const double high = std::min(n - 1, boost::math::quantile(rank, 0.8413447) * n - 1);
  return (sorted[static_cast<std::size_t>(std::ceil(high))] -
          sorted[static_cast<std::size_t>(std::floor(low))]) /
         2;
}

double autocorrelation_time(const Draws& draws) {
  return static_cast<double>(2 * draws.chains * (draws.length / 2)) / ess_mean(draws);
}

double sokal_autocorrelation_time(const Draws& draws) {
  constexpr double window = 5, fewest_times = 50;
  if (!tell_something(draws)) return not_known;
  const Autocovariance covariance(draws);
  const double variance = covariance(0);
  if (!(variance > 0)) return not_known;
  double tau = 1;
  const auto length = static_cast<double>(draws.length);
  for (std::size_t lag = 1; lag < draws.length; ++lag) {
    tau += 2 * covariance(lag) / variance;
    if (static_cast<double>(lag) >= window * tau)
      return length >= fewest_times * tau ? tau : not_known;
  }
  return not_known;
}

}  // namespace wander
