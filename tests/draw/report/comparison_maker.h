// Comparisons for tests of what is made of them: real runs on a scene of the gallery.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lab/compare/comparison.h"
#include "lab/engine.h"
#include "lab/scene_source.h"
#include "records/version.h"

namespace wander::test {

struct ComparisonPlan {
  std::string scene = "gallery:article-1";
  std::vector<std::string> methods{"mlt", "bdpt"};
  std::vector<std::uint64_t> budgets{10'000, 20'000};  // samples
  std::size_t replicates = 3;
};

inline compare::Comparison make_comparison(const ComparisonPlan& plan) {
  const SceneDocument document = open_scene(plan.scene);
  compare::Runs runs;
  runs.provenance = {.scene_name = document.scene.name,
                     .scene_text = document.text,
                     .scene_digest = document.digest,
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
        Rendering run = render({document.scene, find_method(plan.methods[c])}, session);
        runs.runs.push_back(
            {c, b, r, run.seed, run.samples, run.seconds, run.seed_seconds, 0, run.film});
        if (b + 1 == plan.budgets.size() && r == 0) runs.details.push_back(std::move(run));
      }
  session.budget = SampleBudget{5 * plan.budgets.back()};
  runs.reference = {render({document.scene, find_method("bdpt")}, session).film,
                    "a long run of bdpt"};
  return compare::summarize(std::move(runs));
}

// Made once.
inline const compare::Comparison& usual() {
  static const compare::Comparison made = make_comparison({});
  return made;
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

inline compare::Comparison with_bins(const compare::Comparison& found, std::size_t bins) {
  compare::Runs runs = found.runs;
  for (compare::Run& run : runs.runs) stretch(run.film, bins);
  stretch(runs.reference.film, bins);
  for (Rendering& details : runs.details) {
    stretch(details.film, bins);
    for (MutationRecord& mutation : details.mutations) {
      stretch(mutation.proposed_per_bin, bins);
      stretch(mutation.acceptance_per_bin, bins);
    }
  }
  return compare::summarize(std::move(runs));
}

// With more contenders, budgets and replicates, by repetition of what there is.
inline compare::Comparison repeated(const compare::Comparison& source, std::size_t contenders,
                                    std::size_t budgets, std::size_t replicates) {
  const compare::Runs& old = source.runs;
  compare::Runs runs{
      .provenance = old.provenance, .replicates = replicates, .reference = old.reference};
  for (std::size_t c = 0; c < contenders; ++c) {
    compare::Contender contender = old.contenders[c % old.contenders.size()];
    contender.label += fmt::format(" no. {}", c + 1);
    runs.contenders.push_back(contender);
    runs.details.push_back(old.details[c % old.details.size()]);
  }
  for (std::size_t b = 0; b < budgets; ++b) runs.budgets.push_back(std::to_string(10'000 << b));
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
        runs.runs.push_back(std::move(run));
      }
  return compare::summarize(std::move(runs));
}

}  // namespace wander::test
