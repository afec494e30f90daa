#include "statistics/jackknife.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wander {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Jackknife::Jackknife(std::size_t groups, std::span<const double> weights) : rests_(groups, 1.0) {
  if (weights.empty()) return;
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double usual = total - total / static_cast<double>(groups);
  for (std::size_t g = 0; g < groups; ++g) rests_[g] = (total - weights[g]) / usual;
}

double Jackknife::error(std::span<const double> without) const {
  double error = 0;
  errors(without, std::span(&error, 1));
  return error;
}

void Jackknife::errors(std::span<const double> without, std::span<double> errors) const {
  const std::size_t count = errors.size(), groups = rests_.size();
  const auto n = static_cast<double>(groups);
  if (groups < 2) {
    std::ranges::fill(errors, unknown);
    return;
  }
  std::vector<double> means(count), squares(count);
  for (std::size_t g = 0; g < groups; ++g)
    for (std::size_t i = 0; i < count; ++i) means[i] += without[g * count + i] * rests_[g];
  for (double& mean : means) mean /= n;
  for (std::size_t g = 0; g < groups; ++g)
    for (std::size_t i = 0; i < count; ++i) {
      const double deviation = without[g * count + i] - means[i];
      squares[i] += rests_[g] * deviation * deviation;
    }
  for (std::size_t i = 0; i < count; ++i) errors[i] = std::sqrt(squares[i] * (n - 1) / n);
}

double jackknife_error(std::span<const double> without, std::span<const double> weights) {
  return Jackknife(without.size(), weights).error(without);
}

void count_products_once(std::span<double> without, double theta,
                         std::span<const LeftOutPair> pairs) {
  const auto n = static_cast<double>(without.size());
  double squares = 0;
  for (const LeftOutPair& pair : pairs) {
    const double product =
        n * theta - (n - 1) * (without[pair.first] + without[pair.second]) + (n - 2) * pair.without;
    squares += product * product / static_cast<double>(pairs.size());
  }
  const double once = squares * (n - 1) / (2 * n);
  const double error = jackknife_error(without);
  if (!(error > 0) || !std::isfinite(once)) return;
  const double factor = std::sqrt(std::max(0.1, 1 - once / (error * error)));
  const double mean = std::accumulate(without.begin(), without.end(), 0.0) / n;
  for (double& value : without) value = mean + factor * (value - mean);
}

double jackknife_degrees(std::span<const double> squared_deviations) {
  double sum = 0, squares = 0;
  for (const double v : squared_deviations) {
    sum += v;
    squares += v * v;
  }
  const double most = static_cast<double>(squared_deviations.size()) - 1;
  if (!std::isfinite(squares)) return 0;
  return squares > 0 ? std::clamp(sum * sum / squares - 1, 0.0, most) : std::max(0.0, most);
}

RatioJackknife::RatioJackknife(const std::vector<std::vector<double>>& groups,
                               std::span<const double> weights)
    : groups_(groups), jackknife_(groups.size(), weights), totals_(groups.front().size()) {
  for (const auto& group : groups) {
    masses_.push_back(std::accumulate(group.begin(), group.end(), 0.0));
    mass_ += masses_.back();
    for (std::size_t k = 0; k < group.size(); ++k) totals_[k] += group[k];
  }
}

double RatioJackknife::value(std::size_t part) const { return totals_[part] / mass_; }

double RatioJackknife::without(std::size_t part, std::size_t group) const {
  const double rest = mass_ - masses_[group];
  return rest > 1e-12 * mass_ ? std::max(0.0, totals_[part] - groups_[group][part]) / rest
                              : unknown;
}

double RatioJackknife::error(std::size_t part, std::span<const double> b) const {
  std::vector<double> values;
  for (std::size_t g = 0; g < groups_.size(); ++g) values.push_back(b[g] * without(part, g));
  return jackknife_.error(values);
}

}  // namespace wander
