#include "lab/compare/plausible.h"

#include <algorithm>
#include <array>
#include <boost/math/special_functions/trigamma.hpp>
#include <boost/random/gamma_distribution.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/student_t_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <cmath>
#include <numbers>
#include <random>

namespace wander::compare {

namespace {

constexpr std::size_t shapes = 60;
constexpr double least_shape = 0.25, largest_shape = 1e7, largest_spread = 1.5;
constexpr double tempering = 0.5, stretch = 1.15;
constexpr double smallest_share = 1e-12;  // of the mean, that a replicate counts as
constexpr double longest_step = 9;        // of log E D, by Student's t: with R = 2 it has no mean

struct Shape {
  double a, spread, log_gamma;  // spread: of log D
};

const std::array<Shape, shapes>& grid() {
  static const std::array<Shape, shapes> made = [] {
    std::array<Shape, shapes> grid{};
    for (std::size_t i = 0; i < shapes; ++i) {
      const double a =
          least_shape * std::pow(largest_shape / least_shape,
                                 static_cast<double>(i) / static_cast<double>(shapes - 1));
      grid[i] = {a, std::min(std::sqrt(boost::math::trigamma(a)), largest_spread), std::lgamma(a)};
    }
    return grid;
  }();
  return made;
}

struct Replicates {
  double count = 0, mean = 0, error = 0;         // error: s / (D̄ √R)
  double mean_log = 0, squares = 0, log_gm = 0;  // squares: Σ (log D - mean log D)²;  log(GM/D̄)
};

Replicates summary_of(std::span<const double> values) {
  Replicates r;
  r.count = static_cast<double>(values.size());
  for (const double value : values) r.mean += value / r.count;
  const auto log_of = [&](double value) {
    return std::log(std::max(value, smallest_share * r.mean));
  };
  for (const double value : values) r.mean_log += log_of(value) / r.count;
  double variance = 0;
  for (const double value : values) {
    variance += (value / r.mean - 1) * (value / r.mean - 1) / (r.count - 1);
    r.squares += (log_of(value) - r.mean_log) * (log_of(value) - r.mean_log);
  }
  r.error = std::sqrt(variance / r.count);
  r.log_gm = r.mean_log - std::log(r.mean);
  return r;
}

// Running sums of the weights of all shapes, of the gamma law and then of the lognormal.
std::vector<double> cumulative_weights(const Replicates& r) {
  std::vector<double> weight;
  for (const Shape& s : grid())
    weight.push_back(r.count * s.a * r.log_gm - r.count * s.log_gamma + std::lgamma(r.count * s.a) -
                     r.count * s.a * std::log(r.count));
  for (const Shape& s : grid())
    weight.push_back(-(r.count - 1) * std::log(s.spread) - r.squares / (2 * s.spread * s.spread) -
                     std::log(r.count) / 2 - (r.count - 1) / 2 * std::log(2 * std::numbers::pi));
  const double most = *std::ranges::max_element(weight);
  double sum = 0;
  for (double& w : weight) w = sum += std::exp(tempering * (w - most));
  return weight;
}

class Source {
 public:
  Source(const Replicates& replicates, std::uint32_t stream)
      : replicates_(replicates), weights_(cumulative_weights(replicates)), engine_(stream) {}

  // log(E D / D̄)
  double draw() {
    const double third = 3 * uniform_(engine_);
    if (third < 1) return by_student();
    const double u = uniform_(engine_) * weights_.back();
    const auto at =
        static_cast<std::size_t>(std::ranges::upper_bound(weights_, u) - weights_.begin());
    const std::size_t index = std::min(at, weights_.size() - 1);
    return index < shapes ? by_gamma(grid()[index]) : by_lognormal(grid()[index - shapes]);
  }

 private:
  double by_student() {
    boost::random::student_t_distribution<double> t(replicates_.count - 1);
    return std::clamp(replicates_.error * t(engine_), -longest_step, longest_step);
  }
  double by_gamma(const Shape& shape) {
    const double a = replicates_.count * shape.a;
    return std::log(a / boost::random::gamma_distribution<double>(a)(engine_));
  }
  double by_lognormal(const Shape& shape) {
    const double z = normal_(engine_);
    return replicates_.log_gm + shape.spread * z / std::sqrt(replicates_.count) +
           shape.spread * shape.spread / 2;
  }

  Replicates replicates_;
  std::vector<double> weights_;
  std::mt19937_64 engine_;
  boost::random::uniform_01<double> uniform_;
  boost::random::normal_distribution<double> normal_;
};

}  // namespace

std::size_t draw_count_of(std::size_t contenders) {
  constexpr std::size_t draws_per_pair = 160;  // the smallest p-value is 2 / 160 = 0.0125 then
  return std::max(draw_count, draws_per_pair * (contenders * (contenders - 1) / 2));
}

Draws draws_of_mean(std::span<const double> replicates, std::uint32_t stream, std::size_t count) {
  if (replicates.size() < 2) return {};
  const Replicates summary = summary_of(replicates);
  if (!std::isfinite(summary.mean)) return {};
  if (!(summary.mean > 0)) return Draws(count, 0.0);
  Source source(summary, stream);
  Draws draws(count);
  for (double& draw : draws) draw = summary.mean * std::exp(stretch * source.draw());
  return draws;
}

Draws draws_of_reference(double degrees, std::size_t count) {
  std::mt19937_64 engine;
  boost::random::normal_distribution<double> normal;
  boost::random::student_t_distribution<double> student(std::isfinite(degrees) ? degrees : 1);
  Draws draws(count);
  for (double& draw : draws) draw = std::isfinite(degrees) ? student(engine) : normal(engine);
  return draws;
}

Interval interval_of(Draws draws, double value) {
  const std::size_t drawn = draws.size();
  const auto tail = static_cast<std::size_t>(0.025 * static_cast<double>(drawn));
  std::erase_if(draws, [](double x) { return std::isnan(x); });
  if (draws.empty() || std::isnan(value) || drawn - draws.size() > tail) return {};
  std::ranges::sort(draws);
  const auto n = static_cast<double>(draws.size());
  const double low = std::min(draws[static_cast<std::size_t>(0.025 * n)], value);
  const double high = std::max(draws[static_cast<std::size_t>(0.975 * n)], value);
  return {std::isfinite(low) ? low : not_known, std::isfinite(high) ? high : not_known};
}

Measured measured(double value, const Draws& draws) {
  if (!std::isfinite(value)) return {};
  return {value, interval_of(draws, value)};
}

}  // namespace wander::compare
