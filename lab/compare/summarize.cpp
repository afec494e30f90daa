#include <cmath>
#include <stdexcept>
#include <utility>

#include "lab/compare/cautions.h"
#include "lab/compare/crossings.h"
#include "lab/compare/curves.h"
#include "lab/compare/film_loan.h"
#include "lab/compare/verdict.h"

namespace wander::compare {

namespace {

constexpr std::uint32_t streams_per_cell = 3;  // that measure_cell() takes

// [contender][budget]
struct MeasuredCells {
  Measurements all;
  std::vector<CellRuns> runs{};
  std::vector<Disagreement> disagreements{};
};

// Indices of runs, [contender][budget].
std::vector<std::vector<std::size_t>> places_of(const Runs& runs) {
  std::vector<std::vector<std::size_t>> places(runs.contenders.size() * runs.budgets.size());
  for (std::size_t i = 0; i < runs.runs.size(); ++i) {
    const Run& run = runs.runs[i];
    if (run.contender >= runs.contenders.size() || run.budget >= runs.budgets.size())
      throw std::invalid_argument("a run is of a contender or a budget that does not exist");
    places[run.contender * runs.budgets.size() + run.budget].push_back(i);
  }
  return places;
}

// Cells one after the other, each while its films are there.
class CellByCell {
 public:
  CellByCell(Comparison& comparison, const Yardstick& yardstick)
      : comparison_(comparison),
        yardstick_(yardstick),
        reference_(draws_of_reference(yardstick.degrees,
                                      draw_count_of(comparison.runs.contenders.size()))) {
    comparison_.errors.resize(comparison_.runs.runs.size());
  }

  MeasuredCells measure() {
    MeasuredCells result;
    result.all = {comparison_.runs.contenders.size(), comparison_.runs.budgets.size(), {}};
    for (const std::vector<std::size_t>& places : places_of(comparison_.runs)) {
      const FilmLoan loan(comparison_.runs.shelf, runs_at(places));
      result.runs.push_back(usable(places));
      result.disagreements.push_back(disagreement_of(result.runs.back()));
      const std::size_t i = result.all.cells.size();
      const auto stream = streams_per_cell * static_cast<std::uint32_t>(i + 1);
      result.all.cells.push_back(measure_cell(result.runs.back(), yardstick_, reference_, stream));
      result.all.cells.back().cell.contender = i / result.all.budgets;
      result.all.cells.back().cell.budget = i % result.all.budgets;
    }
    return result;
  }

 private:
  std::vector<Run*> runs_at(const std::vector<std::size_t>& places) {
    std::vector<Run*> runs;
    for (const std::size_t i : places) runs.push_back(&comparison_.runs.runs[i]);
    return runs;
  }
  // Those whose films are finite.
  CellRuns usable(const std::vector<std::size_t>& places) {
    CellRuns cell;
    cell.time = comparison_.runs.time;
    for (const std::size_t i : places) {
      const Run& run = comparison_.runs.runs[i];
      comparison_.errors[i] = errors_of(run.film, yardstick_);
      if (std::isnan(comparison_.errors[i].mean)) continue;
      cell.runs.push_back(&run);
      cell.errors.push_back(&comparison_.errors[i]);
    }
    return cell;
  }

  Comparison& comparison_;
  const Yardstick& yardstick_;
  Draws reference_;
};

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
  const MeasuredCells cells = CellByCell(result, yardstick).measure();
  const Measurements& all = cells.all;
  for (const MeasuredCell& cell : all.cells) result.cells.push_back(cell.cell);
  if (all.cells.empty()) return result;
  result.decisive = decisive_budget(all);
  const double asked_for = result.runs.target;
  result.target = std::isnan(asked_for) ? round_target(all, result.decisive) : asked_for;
  measure_contenders(result, all);
  result.ranking = ranking_at(all, result.decisive);
  result.crossings = measure_crossings(all, result.ranking, result.decisive);
  result.cautions = cautions_of(result, cells.runs, cells.disagreements, yardstick);
  result.verdict = verdict_of(result);
  return result;
}

}  // namespace wander::compare
