#include <cmath>
#include <stdexcept>
#include <utility>

#include "lab/compare/cautions.h"
#include "lab/compare/crossings.h"
#include "lab/compare/curves.h"
#include "lab/compare/verdict.h"

namespace wander::compare {

namespace {

constexpr std::uint32_t streams_per_cell = 3;  // that measure_cell() takes

std::vector<CellRuns> runs_of_cells(const Comparison& comparison) {
  const Runs& runs = comparison.runs;
  std::vector<CellRuns> cells(runs.contenders.size() * runs.budgets.size());
  for (std::size_t i = 0; i < runs.runs.size(); ++i) {
    const Run& run = runs.runs[i];
    if (run.contender >= runs.contenders.size() || run.budget >= runs.budgets.size())
      throw std::invalid_argument("a run is of a contender or a budget that does not exist");
    if (std::isnan(comparison.errors[i].mean)) continue;  // its film is not finite
    CellRuns& cell = cells[run.contender * runs.budgets.size() + run.budget];
    cell.time = runs.time;
    cell.runs.push_back(&run);
    cell.errors.push_back(&comparison.errors[i]);
  }
  return cells;
}

Measurements measurements_of(const Comparison& comparison, const std::vector<CellRuns>& cells,
                             const Yardstick& yardstick) {
  Measurements all{comparison.runs.contenders.size(), comparison.runs.budgets.size(), {}};
  const Draws reference = draws_of_reference(yardstick.degrees);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto stream = streams_per_cell * static_cast<std::uint32_t>(i + 1);
    all.cells.push_back(measure_cell(cells[i], yardstick, reference, stream));
    all.cells.back().cell.contender = i / all.budgets;
    all.cells.back().cell.budget = i % all.budgets;
  }
  return all;
}

// The last budget at which every contender was measured; the last of all if there is none.
std::size_t decisive_budget(const Measurements& all) {
  for (std::size_t b = all.budgets; b-- > 0;) {
    std::size_t measured = 0;
    for (std::size_t c = 0; c < all.contenders; ++c)
      if (all.at(c, b).cell.replicates > 0) ++measured;
    if (measured == all.contenders) return b;
  }
  return all.budgets > 0 ? all.budgets - 1 : 0;
}

std::vector<std::vector<ReplicatePoint>> replicates_of(const Comparison& comparison,
                                                       std::size_t contender) {
  std::vector<std::vector<ReplicatePoint>> replicates;
  for (std::size_t i = 0; i < comparison.runs.runs.size(); ++i) {
    const Run& run = comparison.runs.runs[i];
    const double square = comparison.errors[i].relative_mse;
    const double seconds = run.time(comparison.runs.time);
    if (run.contender != contender || std::isnan(square) || !(seconds > 0)) continue;
    if (run.replicate >= replicates.size()) replicates.resize(run.replicate + 1);
    replicates[run.replicate].push_back({square, seconds});
  }
  return replicates;
}

void measure_contenders(Comparison& result, const Measurements& all) {
  for (std::size_t c = 0; c < all.contenders; ++c) {
    result.curves.push_back(measure_curve(all, c, result.target));
    result.profiles.push_back(
        measure_profile(replicates_of(result, c), result.curves.back(), result.target));
  }
}

}  // namespace

Comparison summarize(Runs runs) {
  Comparison result;
  result.runs = std::move(runs);
  const Yardstick yardstick(result.runs.reference);
  for (const Run& run : result.runs.runs) result.errors.push_back(errors_of(run.film, yardstick));
  const std::vector<CellRuns> cells = runs_of_cells(result);
  const Measurements all = measurements_of(result, cells, yardstick);
  for (const MeasuredCell& cell : all.cells) result.cells.push_back(cell.cell);
  if (all.cells.empty()) return result;
  result.decisive = decisive_budget(all);
  const double asked_for = result.runs.target;
  result.target = std::isnan(asked_for) ? round_target(all, result.decisive) : asked_for;
  measure_contenders(result, all);
  result.ranking = ranking_at(all, result.decisive);
  result.crossings = measure_crossings(all, result.ranking, result.decisive);
  result.cautions = cautions_of(result, cells, yardstick);
  result.verdict = verdict_of(result);
  return result;
}

}  // namespace wander::compare
