#include "mlt/run/normalization.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mlt/run/bridge.h"
#include "mlt/run/film_fit.h"
#include "mlt/run/unmet_light.h"
#include "statistics/jackknife.h"
#include "statistics/squared.h"

namespace wander {

namespace {

Estimate mean(const Sum& sum, const Sum& squares, std::uint64_t samples) {
  const double n = static_cast<double>(samples), m = sum.value() / n;
  if (samples < 2) return {m, std::numeric_limits<double>::quiet_NaN()};
  const double variance = std::max(0.0, squares.value() / n - m * m) / (n - 1);
  return {m, std::sqrt(variance)};
}

SeedTally merged(std::span<const GroupFindings> groups) {
  SeedTally tally = *groups.front().seeds;
  for (const GroupFindings& group : groups.subspan(1)) tally.merge(*group.seeds);
  return tally;
}

Constant from_seed_pass(std::span<const GroupFindings> groups) {
  const SeedTally tally = merged(groups);
  Constant constant{.b = mean(tally.total, tally.total_squares, tally.samples),
                    .effective_samples = tally.effective_samples(),
                    .degrees_of_freedom = std::max(0.0, static_cast<double>(tally.samples) - 1)};
  for (const GroupFindings& group : groups) {
    const auto rest = static_cast<double>(tally.samples - group.seeds->samples);
    constant.without.push_back((tally.total.value() - group.seeds->total.value()) / rest);
  }
  return constant;
}

double degrees_of(const Constant& constant) {
  std::vector<double> deviations;
  for (const double b : constant.without)
    deviations.push_back((b - constant.b.value) * (b - constant.b.value));
  return jackknife_degrees(deviations);
}

Constant from_least_squares(std::span<const GroupFindings> groups) {
  std::vector<FilmFitGroup> films;
  for (const GroupFindings& group : groups) {
    FilmFitGroup& film = films.emplace_back(FilmFitGroup{
        values(group.evidence->film), static_cast<double>(group.of_seeds->samples), {}});
    for (const double weight : group.film->weights()) film.deposits.push_back(group.scale * weight);
  }
  FilmFit fit = fit_films(films, groups.front().film->shape());
  if (!fit.failure.empty()) return {.failure = fit.failure};
  Constant constant{.b = {fit.b, jackknife_error(fit.without, weights_of(groups))},
                    .without = std::move(fit.without),
                    .effective_samples = merged(groups).effective_samples()};
  constant.degrees_of_freedom = degrees_of(constant);
  return constant;
}

// b = Σ over the strata, which are independent targets; one in which nothing was found is dark.
Constant from_bridge(std::span<const GroupFindings> groups) {
  Constant constant{.b = {0, 0}, .without = std::vector<double>(groups.size())};
  const auto has_states = [](const GroupFindings& group) {
    return std::ranges::any_of(
        group.states, [](const StateRatios& stratum) { return stratum.ratios->count() > 0; });
  };
  if (std::ranges::none_of(groups, has_states))
    return {.failure = "it needs paths of the seed pass and states of chains"};
  const double unmet = unmet_light(groups);
  // By what the samples of each group found in all strata, for these are the same samples.
  std::vector<double> moved(groups.size());
  double samples = 0;
  for (const GroupFindings& group : groups) samples += static_cast<double>(group.seeds->samples);
  for (std::size_t k = 0; k < groups.front().states.size(); ++k) {
    std::vector<BridgeGroup> sides;
    double found = 0;
    for (const GroupFindings& group : groups) {
      const RatioHistogram& ratios = group.evidence->ratios[k];
      sides.push_back({&ratios, static_cast<double>(group.seeds->samples), group.states[k].ratios,
                       group.states[k].weight});
      found += ratios.count();
    }
    if (found == 0) continue;
    const BridgeFit fit = bridge(sides, unmet);
    if (!fit.failure.empty()) return {.failure = fit.failure};
    constant.b.value += fit.b;
    for (std::size_t g = 0; g < groups.size(); ++g) moved[g] += fit.moved[g];
    for (std::size_t g = 0; g < groups.size(); ++g) constant.without[g] += fit.without[g];
  }
  double spread = 0;
  for (const double of_group : moved) spread += squared(of_group / constant.b.value);
  constant.effective_samples = spread > 0 ? std::min(1 / spread, samples) : samples;
  // A stratum that one group alone found is dark without it; of a film that one alone found nobody knows the error.
  for (double& b : constant.without)
    if (b == 0) b = std::numeric_limits<double>::quiet_NaN();
  constant.b.standard_error = jackknife_error(constant.without, weights_of(groups));
  constant.degrees_of_freedom = degrees_of(constant);
  return constant;
}

void add_estimate(Normalization& record, NormalizationMethod method, const Constants& constants,
                  std::uint64_t samples) {
  const Constant& constant = constants[method];
  record.estimates[std::string(name_of(method))] = {constant.b, samples,
                                                    constant.degrees_of_freedom, constant.failure};
}

// b · Σ_g L_gn / Σ_g Σ_n L_gn of the light L_gn that group g found in paths of n vertices.
std::vector<LengthShare> shares_of_lengths(std::span<const GroupFindings> groups,
                                           const Constant& constant) {
  std::vector<std::vector<double>> light;
  for (const GroupFindings& group : groups) {
    light.push_back(group.film->by_length());
    for (double& value : light.back()) value *= group.scale;
  }
  const RatioJackknife film(light, weights_of(groups));
  std::vector<LengthShare> shares;
  for (std::size_t k = 0; k < light.front().size(); ++k) {
    if (film.value(k) == 0) continue;
    shares.push_back({{constant.b.value * film.value(k), film.error(k, constant.without)},
                      static_cast<int>(k) + 2});
  }
  return shares;
}

}  // namespace

std::string_view name_of(NormalizationMethod method) {
  constexpr std::array<std::string_view, 4> names{"seed_pass", "least_squares", "bridge", "pooled"};
  return names[static_cast<std::size_t>(method)];
}

const Constant& Constants::operator[](NormalizationMethod method) const {
  switch (method) {
    case NormalizationMethod::least_squares:
      return least_squares;
    case NormalizationMethod::bridge:
      return bridge;
    case NormalizationMethod::pooled:
      return pooled;
    case NormalizationMethod::seed_pass:
      break;
  }
  return seed_pass;
}

NormalizationMethod Constants::usable(NormalizationMethod method) const {
  return (*this)[method].failure.empty() ? method : NormalizationMethod::seed_pass;
}

Constants constants(std::span<const GroupFindings> groups) {
  return {from_seed_pass(groups), from_least_squares(groups), from_bridge(groups)};
}

Normalization normalization(std::span<const GroupFindings> groups, const Constants& constants,
                            NormalizationMethod method) {
  const NormalizationMethod used = constants.usable(method);
  const SeedTally tally = merged(groups);
  Normalization record = normalization(tally);
  static_cast<Estimate&>(record) = constants[used].b;
  record.method = name_of(used);
  for (const auto each : {NormalizationMethod::seed_pass, NormalizationMethod::least_squares,
                          NormalizationMethod::bridge})
    add_estimate(record, each, constants, tally.samples);
  if (constants.pooled.failure.empty())
    add_estimate(record, NormalizationMethod::pooled, constants, tally.samples);
  if (used != NormalizationMethod::seed_pass)
    record.by_length = shares_of_lengths(groups, constants[used]);
  return record;
}

Normalization normalization(const SeedTally& tally) {
  Normalization b;
  static_cast<Estimate&>(b) = mean(tally.total, tally.total_squares, tally.samples);
  b.method = name_of(NormalizationMethod::seed_pass);
  b.estimates[b.method] = {{b.value, b.standard_error},
                           tally.samples,
                           std::max(0.0, static_cast<double>(tally.samples) - 1)};
  for (std::size_t k = 0; k < tally.sum.size(); ++k) {
    if (tally.sum[k].value() == 0) continue;
    b.by_length.push_back(
        {mean(tally.sum[k], tally.squares[k], tally.samples), static_cast<int>(k) + 2});
  }
  return b;
}

}  // namespace wander
