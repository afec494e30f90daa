// The two sides of a bridge, drawn by a known law, and studies of many of them.
#pragma once

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "core/rng.h"
#include "mlt/run/bridge.h"
#include "statistics/jackknife.h"

namespace wander::test::bridge_sides {

// The seed pass finds a path in a sample with probability `found`, of l = (b / found) e^(σz - σ²/2)
// with z normal, so that its mean is b; the chains, whose density is in proportion to l, see z + σ.
struct Model {
  double found = 0.3, sigma = 1;
  int samples = 20'000, states = 32'000;  // of all groups
  double b = 1;
};
inline constexpr int groups = 32;

struct Side {
  RatioHistogram ratios;
  std::vector<double> values;  // the same, one by one
  void add(double l) {
    ratios.add(l);
    values.push_back(l);
  }
};
struct Sides {
  std::vector<Side> found = std::vector<Side>(groups), states = std::vector<Side>(groups);
  double samples_of_group = 0, direct = 0;

  std::vector<BridgeGroup> data() const {
    std::vector<BridgeGroup> data;
    for (std::size_t g = 0; g < groups; ++g)
      data.push_back({&found[g].ratios, samples_of_group, &states[g].ratios, 1});
    return data;
  }
};

inline double normal(Rng& random) {
  const double u = random.uniform();
  return boost::math::quantile(boost::math::normal(), 0x1p-54 + u * (1 - 0x1p-53));
}

inline Sides simulate(const Model& model, std::uint64_t seed) {
  Sides sides;
  Rng random(seed, Purpose::test, 70);
  const auto ratio = [&](double shift) {
    const double z = normal(random) + shift;
    return model.b / model.found * std::exp(model.sigma * z - model.sigma * model.sigma / 2);
  };
  sides.samples_of_group = model.samples / groups;
  double total = 0;
  for (auto& side : sides.found)
    for (int i = 0; i < model.samples / groups; ++i) {
      if (!(random.uniform() < model.found)) continue;
      side.add(ratio(0));
      total += side.values.back();
    }
  for (auto& side : sides.states)
    for (int i = 0; i < model.states / groups; ++i) side.add(ratio(model.sigma));
  sides.direct = total / (sides.samples_of_group * groups);
  return sides;
}

// The fixed point of the equation of bridge.h, over the values one by one [Meng and Wong 1996].
inline double fixed_point(const Sides& sides, double balance) {
  double b = sides.direct, states = 0;
  for (const Side& side : sides.states) states += static_cast<double>(side.values.size());
  for (int i = 0; i < 500; ++i) {
    double above = 0, below = 0;
    for (const Side& side : sides.found)
      for (const double l : side.values) above += l / (balance * l + b);
    for (const Side& side : sides.states)
      for (const double l : side.values) below += 1 / (balance * l + b);
    b = (above / (sides.samples_of_group * groups)) / (below / states);
  }
  return b;
}

struct Study {
  double bias = 0, rmse = 0, coverage = 0;  // of log b
  double direct_rmse = 0;
};

template <class AnyModel, class Estimate>
Study study(const AnyModel& model, int runs, Estimate&& estimate) {
  Study s;
  for (int run = 0; run < runs; ++run) {
    const auto sides = simulate(model, static_cast<std::uint64_t>(100 + run));
    const auto [b, error] = estimate(sides);
    const double t = 2.04;  // 31 degrees of freedom
    s.bias += (b - model.b) / runs;
    s.rmse += (b - model.b) * (b - model.b) / runs;
    s.coverage += (std::abs(b - model.b) <= t * error ? 1.0 : 0.0) / runs;
    s.direct_rmse += (sides.direct - model.b) * (sides.direct - model.b) / runs;
  }
  s.rmse = std::sqrt(s.rmse);
  s.direct_rmse = std::sqrt(s.direct_rmse);
  return s;
}

inline std::pair<double, double> bridged(const Sides& sides) {
  const BridgeFit fit = bridge(sides.data());
  return {fit.b, jackknife_error(fit.without)};
}

}  // namespace wander::test::bridge_sides
