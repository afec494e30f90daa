#include "lab/compare/cautions.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "lab/wording.h"
#include "statistics/decision.h"
#include "statistics/median.h"
#include "statistics/number_text.h"

namespace wander::compare {

namespace {

constexpr double noise_that_matters = 0.1;  // of the least square error that is measured
constexpr double least_coverage = 0.9;      // of 95 % intervals
constexpr double least_reliable = 0.95;     // share of bins

// The contenders of which something is said, each with a number.
class Named {
 public:
  void add(const Comparison& comparison, std::size_t contender, const std::string& number) {
    text_ += fmt::format("{}{} ({})", text_.empty() ? "" : ", ",
                         comparison.runs.contenders[contender].label, number);
  }
  void say(std::vector<std::string>& cautions, const char* sentence) const {
    if (!text_.empty()) cautions.push_back(fmt::format(fmt::runtime(sentence), text_));
  }

 private:
  std::string text_;
};

struct View {
  const Comparison& comparison;
  const std::vector<CellRuns>& cells;
  const std::vector<Disagreement>& disagreements;

  std::size_t contenders() const { return comparison.runs.contenders.size(); }
  std::size_t at(std::size_t contender) const {
    return contender * comparison.runs.budgets.size() + comparison.decisive;
  }
};

// An interrupted comparison may have none.
bool has_reference(const Runs& runs) {
  return std::ranges::any_of(runs.reference.film.value, [](double x) { return std::isfinite(x); });
}

void of_missing_runs(std::vector<std::string>& cautions, const View& view) {
  const Runs& runs = view.comparison.runs;
  const std::size_t planned = runs.contenders.size() * runs.budgets.size() * runs.replicates;
  const std::size_t made = runs.runs.size() + runs.failures.size();
  if (!runs.complete || made < planned)
    cautions.push_back(
        fmt::format("The comparison is not complete: {} of {} runs were made.", made, planned));
  for (std::size_t c = 0; c < view.contenders(); ++c) {
    const auto failed = std::ranges::count(runs.failures, c, &FailedRun::contender);
    const std::size_t all = runs.budgets.size() * runs.replicates;
    if (static_cast<std::size_t>(failed) == all)
      cautions.push_back(fmt::format("All {} runs of {} failed.", all, runs.contenders[c].label));
    else if (failed > 0)
      cautions.push_back(
          fmt::format("{} of {} runs of {} failed: its errors are those of the rest.", failed, all,
                      runs.contenders[c].label));
  }
  if (!has_reference(runs)) return;
  const auto broken = std::ranges::count_if(
      view.comparison.errors, [](const RunErrors& errors) { return std::isnan(errors.mean); });
  if (broken > 0)
    cautions.push_back(
        fmt::format("{} of {} runs hold values that are not finite, and are left out.", broken,
                    runs.runs.size()));
}

void of_the_reference(std::vector<std::string>& cautions, const View& view,
                      const Yardstick& yardstick) {
  const auto& doubts = view.comparison.runs.reference.doubts;
  cautions.insert(cautions.end(), doubts.begin(), doubts.end());
  if (!has_reference(view.comparison.runs)) {
    cautions.emplace_back("There is no reference to measure errors against.");
    return;
  }
  if (!(yardstick.mean_square > 0)) {
    cautions.emplace_back("The reference is dark: there are no relative errors.");
    return;
  }
  if (yardstick.bins_of_unknown_error > 0)
    cautions.push_back(
        fmt::format("The reference does not know its own error in {} of {} bins, which count as "
                    "exact.",
                    yardstick.bins_of_unknown_error, yardstick.value.size()));
  const double noise = std::sqrt(yardstick.noise / yardstick.mean_square);
  double least = not_known;
  for (std::size_t c = 0; c < view.contenders(); ++c)
    least = std::fmin(least, view.comparison.cells[view.at(c)].relative_rmse.value);
  if (noise * noise > noise_that_matters * least * least)
    cautions.push_back(
        fmt::format("The reference's own error, {}, is not small against the least that is "
                    "measured, {}: it is subtracted, and widens the intervals.",
                    percent(noise), percent(least)));
}

void of_the_replicates(std::vector<std::string>& cautions, const View& view) {
  Named disagreeing, biased, dark;
  for (std::size_t c = 0; c < view.contenders(); ++c) {
    const Cell& cell = view.comparison.cells[view.at(c)];
    if (cell.is_dark) {
      dark.add(view.comparison, c, percent(cell.relative_rmse.value));
      continue;
    }
    const Disagreement& found = view.disagreements[view.at(c)];
    if (found.ratio > found.threshold)
      disagreeing.add(view.comparison, c, number_text(found.ratio, 2) + " times");
    const Measured& bias = cell.bias;
    if (bias.interval.low > 0)
      biased.add(view.comparison, c,
                 fmt::format("{}, {} to {}", percent(bias.value), percent(bias.interval.low),
                             percent(bias.interval.high)));
  }
  dark.say(
      cautions,
      "No replicate found any light, so that the error is that of black films, and tells nothing "
      "of how good the method is: {}.");
  disagreeing.say(cautions,
                  "Replicates differ by more than their own error bars say, so that some may miss "
                  "a part of the light: {}.");
  biased.say(cautions,
             "Beyond chance, the mean of the replicates is not the reference, for bias or because "
             "all miss the same light: {}.");
}

// Beyond what so few replicates can tell.
bool undercovers(const CellRuns& cell) {
  Moments coverage;
  for (const RunErrors* errors : cell.errors)
    if (std::isfinite(errors->coverage)) coverage.add(errors->coverage);
  if (coverage.count() < 2) return false;
  const double t = student_threshold(0.05, static_cast<double>(coverage.count() - 1));
  return coverage.mean() + t * coverage.standard_error() < least_coverage;
}

void of_the_error_bars(std::vector<std::string>& cautions, const View& view) {
  Named uncovered, sloping, unreliable;
  for (std::size_t c = 0; c < view.contenders(); ++c) {
    const CellRuns& cell = view.cells[view.at(c)];
    if (view.comparison.cells[view.at(c)].is_dark) continue;  // that is said of it already
    if (undercovers(cell))
      uncovered.add(view.comparison, c, percent(view.comparison.cells[view.at(c)].coverage));
    const Curve& curve = view.comparison.curves[c];
    if (!curve.inverse_root)
      sloping.add(view.comparison, c, number_text(curve.slope_time.value, 2));
    std::vector<double> shares;
    for (const RunErrors* errors : cell.errors)
      if (std::isfinite(errors->reliable_share)) shares.push_back(errors->reliable_share);
    const double reliable = median(shares);
    if (reliable < least_reliable) unreliable.add(view.comparison, c, percent(reliable));
  }
  uncovered.say(cautions, "The runs' own 95 % intervals hold the reference less often: {}.");
  sloping.say(cautions,
              "The error does not fall like 1/√t, a slope of −0.5, so that nothing is "
              "extrapolated: {}.");
  unreliable.say(cautions, "Few bins of a run are reliable: {}.");
}

}  // namespace

Disagreement disagreement_of(const CellRuns& cell) {
  const std::size_t count = cell.runs.size();
  if (count < 2) return {};
  double spread = 0, claimed = 0;
  for (std::size_t j = 0; j < cell.runs.front()->film.value.size(); ++j) {
    Moments values, squares;
    for (const Run* run : cell.runs) {
      const FilmEstimate& film = run->film;
      if (j >= film.standard_error.size() || !std::isfinite(film.standard_error[j])) break;
      if (j < film.reliable.size() && !film.reliable[j]) break;
      values.add(film.value[j]);
      squares.add(film.standard_error[j] * film.standard_error[j]);
    }
    if (values.count() < count) continue;
    spread += values.variance();
    claimed += squares.mean();
  }
  if (!(claimed > 0)) return {};
  constexpr double most_degrees = 1e6, rate = 1e-3;
  const double given = cell.runs.front()->film.degrees_of_freedom;
  const double degrees = given >= 1 ? std::min(given, most_degrees) : most_degrees;
  const boost::math::fisher_f law(static_cast<double>(count - 1), degrees);
  return {std::sqrt(spread / claimed), std::sqrt(quantile(complement(law, rate)))};
}

std::vector<std::string> cautions_of(const Comparison& comparison,
                                     const std::vector<CellRuns>& cells,
                                     const std::vector<Disagreement>& disagreements,
                                     const Yardstick& yardstick) {
  std::vector<std::string> cautions;
  const View view{comparison, cells, disagreements};
  of_missing_runs(cautions, view);
  of_the_reference(cautions, view, yardstick);
  of_the_replicates(cautions, view);
  of_the_error_bars(cautions, view);
  return cautions;
}

}  // namespace wander::compare
