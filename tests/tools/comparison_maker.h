// Comparisons for tests of what is made of them: real runs on a scene of the gallery, and findings
// filled in by plain rules, so that reports can be tested without the verb.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/output/version.h"
#include "tools/compare/comparison.h"
#include "tools/methods.h"
#include "tools/scene_source.h"

namespace wander::test {

struct ComparisonPlan {
  std::string scene = "gallery:article-1";
  std::vector<std::string> methods{"mlt", "bdpt"};
  std::vector<std::uint64_t> budgets{20'000, 40'000};  // samples
  std::size_t replicates = 3;
};

// The root of Σ (x - I)² / Σ I².
inline double relative_distance(const FilmEstimate& film, const FilmEstimate& reference) {
  double squares = 0, size = 0;
  for (std::size_t k = 0; k < film.value.size(); ++k) {
    squares += (film.value[k] - reference.value[k]) * (film.value[k] - reference.value[k]);
    size += reference.value[k] * reference.value[k];
  }
  return std::sqrt(squares / size);
}

inline compare::Measured around(double value) { return {value, {0.8 * value, 1.25 * value}}; }

inline compare::Cell cell_of(const compare::Runs& runs, std::size_t contender, std::size_t budget) {
  compare::Cell cell;
  cell.contender = contender;
  cell.budget = budget;
  double squares = 0, seconds = 0, samples = 0;
  for (const compare::Run& run : runs.runs) {
    if (run.contender != contender || run.budget != budget) continue;
    ++cell.replicates;
    const double error = relative_distance(run.film, runs.reference.film);
    squares += error * error;
    seconds += run.seconds;
    samples += static_cast<double>(run.samples);
  }
  const auto count = static_cast<double>(cell.replicates);
  cell.relative_rmse = cell.median_relative_rmse = around(std::sqrt(squares / count));
  cell.seconds = {seconds / count, {0.9 * seconds / count, 1.1 * seconds / count}};
  cell.samples = {samples / count, {}};
  cell.rmse = cell.mae = cell.rel_mse = around(squares / count);
  cell.efficiency = around(count / squares * count / seconds);
  cell.coverage = 0.94;
  cell.claimed_relative_error = std::sqrt(squares / count);
  return cell;
}

// Findings by plain rules: slopes from the first and the last budget, the better one ahead from the
// middle of the times on.
inline void fill_findings(compare::Comparison& found) {
  const compare::Runs& runs = found.runs;
  found.target = 0.05;
  for (std::size_t c = 0; c < runs.contenders.size(); ++c) {
    for (std::size_t b = 0; b < runs.budgets.size(); ++b)
      found.cells.push_back(cell_of(runs, c, b));
    const compare::Cell &first = found.cells[c * runs.budgets.size()], &last = found.cells.back();
    compare::Curve curve;
    curve.contender = c;
    if (runs.budgets.size() > 1)
      curve.slope_time = {std::log(last.relative_rmse.value / first.relative_rmse.value) /
                              std::log(last.seconds.value / first.seconds.value),
                          {-0.7, -0.3}};
    curve.seconds_to_target = around(0.3 + 0.1 * static_cast<double>(c));
    found.curves.push_back(curve);
    compare::Profile profile{.contender = c};
    for (std::size_t r = 0; r < runs.replicates; ++r) {
      profile.seconds.push_back(0.1 * static_cast<double>(c + 1) + 0.05 * static_cast<double>(r));
      profile.share.push_back(static_cast<double>(r + 1) / static_cast<double>(runs.replicates));
    }
    found.profiles.push_back(std::move(profile));
    found.ranking.push_back(c);
    for (std::size_t behind = 0; behind < c; ++behind)
      found.crossings.push_back({.ahead = c,
                                 .behind = behind,
                                 .seconds = {(first.seconds.value + last.seconds.value) / 2, {}},
                                 .significant = (c + behind) % 2 == 1,
                                 .speedup = around(2)});
  }
  found.verdict = {"The first contender is ahead from 0.1 s on.",
                   "The others do not differ significantly."};
}

inline compare::Comparison make_comparison(const ComparisonPlan& plan) {
  const SceneDocument document = open_scene(plan.scene);
  compare::Comparison found;
  compare::Runs& runs = found.runs;
  runs.provenance = {.scene_name = document.scene.name,
                     .scene_text = document.text,
                     .scene_sha256 = document.sha256,
                     .dimension = document.scene.dimension,
                     .command_line = "wander compare " + plan.scene + " -o 'a <dir> & more'",
                     .version = program_version()};
  runs.replicates = plan.replicates;
  for (const std::string& method : plan.methods)
    runs.contenders.push_back({method, method, {}, {}});
  for (const std::uint64_t samples : plan.budgets) runs.budgets.push_back(std::to_string(samples));
  Session session;
  for (std::size_t b = 0; b < plan.budgets.size(); ++b)
    for (std::size_t r = 0; r < plan.replicates; ++r)
      for (std::size_t c = 0; c < plan.methods.size(); ++c) {
        session.seed = 1 + (b * plan.replicates + r) * plan.methods.size() + c;
        session.budget = SampleBudget{plan.budgets[b]};
        Rendering run = render(document.scene, plan.methods[c], {}, session);
        runs.runs.push_back(
            {c, b, r, run.seed, run.samples, run.seconds, run.seed_seconds, 0, run.film});
        if (b + 1 == plan.budgets.size() && r == 0) runs.details.push_back(std::move(run));
      }
  session.budget = SampleBudget{20 * plan.budgets.back()};
  runs.reference = {render(document.scene, "bdpt", {}, session).film, "a long run of bdpt"};
  fill_findings(found);
  return found;
}

// Each quantity per bin repeated or left out until there are so many.
template <class Values>
void stretch(Values& values, std::size_t bins) {
  const Values old = values;
  if (old.empty()) return;
  values.resize(bins);
  for (std::size_t k = 0; k < bins; ++k) values[k] = old[k * old.size() / bins];
}

inline void stretch(FilmEstimate& film, std::size_t bins) {
  film.shape = {static_cast<int>(bins)};
  stretch(film.value, bins);
  stretch(film.standard_error, bins);
  stretch(film.reliable, bins);
  for (auto& [vertices, part] : film.by_length) stretch(part, bins);
}

inline compare::Comparison with_bins(compare::Comparison found, std::size_t bins) {
  for (compare::Run& run : found.runs.runs) stretch(run.film, bins);
  stretch(found.runs.reference.film, bins);
  for (Rendering& details : found.runs.details) {
    stretch(details.film, bins);
    for (MutationRecord& mutation : details.mutations) {
      stretch(mutation.proposed_per_bin, bins);
      stretch(mutation.acceptance_per_bin, bins);
    }
  }
  return found;
}

// With more contenders, budgets and replicates, by repetition of what there is.
inline compare::Comparison repeated(const compare::Comparison& source, std::size_t contenders,
                                    std::size_t budgets, std::size_t replicates) {
  compare::Comparison found;
  const compare::Runs& old = source.runs;
  found.runs = {.provenance = old.provenance, .replicates = replicates, .reference = old.reference};
  for (std::size_t c = 0; c < contenders; ++c) {
    compare::Contender contender = old.contenders[c % old.contenders.size()];
    contender.label += fmt::format(" no. {}", c + 1);
    found.runs.contenders.push_back(contender);
    found.runs.details.push_back(old.details[c % old.details.size()]);
  }
  for (std::size_t b = 0; b < budgets; ++b)
    found.runs.budgets.push_back(std::to_string(10'000 << b));
  for (std::size_t b = 0; b < budgets; ++b)
    for (std::size_t r = 0; r < replicates; ++r)
      for (std::size_t c = 0; c < contenders; ++c) {
        compare::Run run = *std::ranges::find_if(old.runs, [&](const compare::Run& candidate) {
          return candidate.contender == c % old.contenders.size() &&
                 candidate.replicate == r % old.replicates;
        });
        run.contender = c;
        run.budget = b;
        run.replicate = r;
        run.samples <<= b;
        run.seconds *= static_cast<double>(1 << b);
        found.runs.runs.push_back(std::move(run));
      }
  fill_findings(found);
  return found;
}

}  // namespace wander::test
