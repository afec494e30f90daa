#include "lab/compare/cells.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "lab/compare/bias.h"
#include "statistics/decision.h"
#include "statistics/median.h"

namespace wander::compare {

namespace {

template <class Value>
std::vector<double> over_runs(const CellRuns& cell, Value value) {
  std::vector<double> values;
  for (std::size_t r = 0; r < cell.runs.size(); ++r)
    values.push_back(value(*cell.runs[r], *cell.errors[r]));
  return values;
}

Measured median_and_range(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [least, most] = std::ranges::minmax_element(values);
  return {median(values), {*least, *most}};
}

// Between order statistics, free of any distribution: the k-th from both ends, where a median
// falls outside with probability 2 P(Bin(R, 1/2) < k) <= 5 %.  Six replicates are the fewest.
Measured median_with_interval(std::vector<double> values) {
  if (values.empty()) return {};
  Measured result{median(values), {}};
  const auto n = static_cast<double>(values.size());
  std::size_t k = 0;
  while (static_cast<double>(k) < n / 2 &&
         2 * cdf(boost::math::binomial(n, 0.5), static_cast<double>(k)) <= 0.05)
    ++k;
  if (k == 0) return result;
  std::ranges::sort(values);
  result.interval = {values[k - 1], values[values.size() - k]};
  return result;
}

// Draws of a mean square less the reference's part of it.
struct Square {
  double mean, noise;          // D̄ and mean e²
  double paired;               // U; not known for a single replicate
  std::span<const double> of;  // D_r
};

// What the variance alone can plausibly be at a draw of E D: the share V/D̄ of it, and where that
// is less, so much less as if all the spread of D were that of V.
double least_square(const Square& square, double draw) {
  const double share = std::clamp(1 - square.paired / square.mean, 0.0, 1.0);
  if (!(share > 0)) return 0;
  return square.mean * share *
         std::min(draw / square.mean, std::pow(draw / square.mean, 1 / share));
}

Draws draws_of_square(const Square& square, const Draws& reference, std::uint32_t stream) {
  Draws draws = draws_of_mean(square.of, stream, reference.size());
  if (!(square.noise > 0)) return draws;
  const double bias = std::max(square.paired - square.noise, 0.0);
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const double t = reference[i];
    const double drawn = draws[i] - t * t * square.noise + 2 * t * std::sqrt(square.noise * bias);
    draws[i] = std::max(drawn, least_square(square, draws[i]));
  }
  return draws;
}

Draws mapped(Draws draws, double (*f)(double), double factor) {
  for (double& draw : draws) draw = factor * f(draw);
  return draws;
}

double root(double x) { return std::sqrt(std::max(x, 0.0)); }
double inverse(double x) { return 1 / x; }
double itself(double x) { return x; }

bool is_dark(const CellRuns& runs) {
  return std::ranges::all_of(runs.runs, [](const Run* run) {
    return std::ranges::all_of(run->film.value, [](double value) { return value == 0; });
  });
}

double mean_of(const std::vector<double>& values) { return Moments(values).mean(); }

void measure_self_knowledge(MeasuredCell& result, const CellRuns& runs) {
  const auto known = [](std::vector<double> values) {
    std::erase_if(values, [](double x) { return !std::isfinite(x); });
    return values;
  };
  const auto claimed =
      known(over_runs(runs, [](auto&, auto& e) { return e.claimed_relative_error; }));
  const auto coverage = known(over_runs(runs, [](auto&, auto& e) { return e.coverage; }));
  if (!claimed.empty()) result.cell.claimed_relative_error = median(claimed);
  if (!coverage.empty()) result.cell.coverage = mean_of(coverage);
}

// Mean square errors: of each bin alike, and weighted.
void measure_squares(MeasuredCell& result, const std::vector<Distance>& distances,
                     const Yardstick& yardstick, const PairedSquare& pairs, const Draws& reference,
                     std::uint32_t stream) {
  std::vector<double> squares, weighted;
  for (const Distance& d : distances) {
    squares.push_back(d.square);
    weighted.push_back(d.weighted);
  }
  Cell& cell = result.cell;
  const double mean = mean_of(squares), mse = mean - yardstick.noise;
  const Draws draws =
      draws_of_square({mean, yardstick.noise, pairs.value, squares}, reference, stream);
  cell.rmse = measured(yardstick.unit * root(mse), mapped(draws, root, yardstick.unit));
  if (!(yardstick.mean_square > 0)) return;
  result.relative_mse = mse / yardstick.mean_square;
  result.draws = mapped(draws, itself, 1 / yardstick.mean_square);
  cell.relative_rmse = measured(root(result.relative_mse), mapped(result.draws, root, 1));
  const double mean_weighted = mean_of(weighted), share = pairs.value / mean;
  cell.rel_mse = measured(
      mean_weighted - yardstick.weighted_noise,
      draws_of_square({mean_weighted, yardstick.weighted_noise, share * mean_weighted, weighted},
                      reference, stream + 1));
  if (result.relative_mse > 0)
    cell.efficiency = measured(1 / (result.relative_mse * cell.seconds.value),
                               mapped(result.draws, inverse, 1 / cell.seconds.value));
}

}  // namespace

MeasuredCell measure_cell(const CellRuns& runs, const Yardstick& yardstick, const Draws& reference,
                          std::uint32_t stream) {
  MeasuredCell result;
  Cell& cell = result.cell;
  cell.replicates = runs.runs.size();
  if (runs.runs.empty()) return result;
  cell.is_dark = yardstick.mean_square > 0 && is_dark(runs);
  cell.seconds =
      median_and_range(over_runs(runs, [&](auto& r, auto&) { return r.time(runs.time); }));
  cell.samples = median_and_range(
      over_runs(runs, [](auto& r, auto&) { return static_cast<double>(r.samples); }));
  std::vector<Distance> distances;
  for (const Run* run : runs.runs) distances.push_back(distance(run->film, yardstick));
  const PairedSquare pairs = paired_square(runs, yardstick);
  measure_squares(result, distances, yardstick, pairs, reference, stream);
  if (yardstick.mean_square > 0)
    cell.median_relative_rmse =
        median_with_interval(over_runs(runs, [](auto&, auto& e) { return e.relative_rmse; }));
  const auto absolute = over_runs(runs, [](auto&, auto& e) { return e.mae; });
  cell.mae = measured(mean_of(absolute), draws_of_mean(absolute, stream + 2));
  cell.bias = relative_bias(pairs, runs.runs.size(), yardstick);
  cell.relative_error_of_mean = error_of_mean(runs, yardstick);
  measure_self_knowledge(result, runs);
  return result;
}

}  // namespace wander::compare
