// Error against what it costs: curves, slopes, crossings, and the time to a target.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "tools/report/embedding.h"
#include "tools/report/error_figure.h"
#include "tools/report/numbers.h"
#include "tools/report/sections.h"
#include "tools/report/table.h"
#include "tools/wording.h"

namespace wander::report {
namespace {

using compare::Crossing;
using compare::Curve;
using compare::Measured;

void write_curves(Html& html, const Subject& subject) {
  const std::vector<Crossing> marked = marked_crossings(subject.comparison);
  std::string caption =
      "Relative root mean square error over replicates against the wall time of sampling, seed "
      "pass "
      "included; bars are 95 % intervals, and lower left is better. Both axes are logarithmic: "
      "independent samples fall along a slope of −1/2.";
  if (!marked.empty())
    caption += " Dashed lines stand where one contender overtakes another for good.";
  write_figure(html, error_time_figure(subject.comparison, "Error against time"), caption);
  write_figure(html, error_samples_figure(subject.comparison),
               "The same errors against the number of samples, which does not depend on the "
               "machine. A sample is a path for pt and lt, a pair of subpaths for bdpt and a "
               "mutation for chains, so contenders of different kinds compare by time, not here.");
  std::size_t hidden = 0;
  for (const Cell& cell : subject.comparison.cells)
    if (cell.replicates > 0 && !(cell.relative_rmse.value > 0)) ++hidden;
  if (hidden > 0)
    html.element("p",
                 fmt::format("Not drawn: {} whose error cannot be told from that of the reference.",
                             counted(hidden, "cell")),
                 {{"class", "note"}});
}

std::string reading(const Curve& curve) {
  if (!std::isfinite(curve.slope_time.value)) return "not known";
  if (curve.inverse_root) return "does not differ significantly from −1/2";
  return curve.slope_time.value > -0.5 ? "flatter than −1/2: a bias, or chains that mix slowly"
                                       : "steeper than −1/2: a start that wears off";
}

void write_slopes(Html& html, const Subject& subject) {
  const std::vector<Curve>& curves = subject.comparison.curves;
  if (curves.empty()) return;
  if (subject.runs().budgets.size() < 2)
    html.element("p", "One budget has no slope: two or more show how the error falls.",
                 {{"class", "note"}});
  std::vector<std::string> names, words;
  std::vector<Measured> time, samples, target;
  for (const Curve& curve : curves) {
    names.push_back(subject.label(curve.contender));
    time.push_back(curve.slope_time);
    samples.push_back(curve.slope_samples);
    target.push_back(curve.seconds_to_target);
    words.push_back(reading(curve));
  }
  Table table = named_rows("Slopes of log error over log cost; independent samples have −1/2.",
                           "contender", names);
  table.add_measured("against time", time);
  table.add_measured("against samples", samples);
  if (subject.comparison.target > 0)
    table.add_measured(fmt::format("time to {}, s", percent(subject.comparison.target)), target);
  table.add_column({"the slope against time", Kind::words}, words);
  write_table(html, table);
}

std::string in_words(const Subject& subject, const Crossing& crossing) {
  const std::string &ahead = subject.label(crossing.ahead),
                    &behind = subject.label(crossing.behind);
  const std::string chance = std::isfinite(crossing.p_value)
                                 ? fmt::format(" (p = {})", number_text(crossing.p_value, 2))
                                 : std::string();
  if (!crossing.significant)
    return fmt::format("{} and {}: not significant{}.", ahead, behind, chance);
  std::string text = fmt::format("{} is ahead of {}", ahead, behind);
  if (crossing.seconds.value > 0) {
    text += fmt::format(" from {} on", duration_in_words(crossing.seconds.value));
    if (const std::string interval = rounded(crossing.seconds.interval); !interval.empty())
      text += fmt::format(", 95 %: {} s", interval);
  } else if (crossing.seconds.value == 0) {
    text += " from the first budget on";
  }
  text += chance;
  if (std::isfinite(crossing.speedup.value))
    text += fmt::format("; its mean square error is {} times as small",
                        with_interval(crossing.speedup));
  if (std::isfinite(crossing.efficiency.value))
    text += fmt::format(", {} times at equal time", with_interval(crossing.efficiency));
  return text + ".";
}

void write_crossings(Html& html, const Subject& subject) {
  if (subject.comparison.crossings.empty()) return;
  html.element("h3", "Who is ahead, and from when on");
  html.element("p",
               fmt::format("At budget {}, with p-values corrected for all pairs; below 0.05 counts "
                           "as significant.",
                           subject.runs().budgets[subject.comparison.decisive]));
  const auto list = html.open("ul");
  for (const Crossing& crossing : subject.comparison.crossings)
    html.element("li", in_words(subject, crossing));
}

void write_profile(Html& html, const Subject& subject) {
  const double target = subject.comparison.target;
  if (subject.comparison.profiles.empty() || !(target > 0)) return;
  html.element("h3", fmt::format("Time to a relative error of {}", percent(target)));
  write_figure(
      html, profile_figure(subject.comparison),
      fmt::format("The share of replicates whose error has come down to {} within a time: "
                  "farther left is faster, and a steep rise means that seeds agree. A curve "
                  "that stays below 100 % belongs to a contender of which some runs do not "
                  "come there.",
                  percent(target)));
}

struct CellColumn {
  const char* heading;
  Measured Cell::*what;
  double unit;
};
constexpr CellColumn cell_columns[] = {
    {"relative RMSE, %", &Cell::relative_rmse, 100},
    {"median relative RMSE, %", &Cell::median_relative_rmse, 100},
    {"RMSE, film units", &Cell::rmse, 1},
    {"MAE, film units", &Cell::mae, 1},
    {"relMSE", &Cell::rel_mse, 1},
    {"bias, %", &Cell::bias, 100},
    {"error of the mean, %", &Cell::relative_error_of_mean, 100},
    {"efficiency, 1/s", &Cell::efficiency, 1},
};

void write_cells(Html& html, const Subject& subject) {
  std::vector<std::string> names, budgets, coverage;
  std::vector<double> seconds, samples, claimed;
  std::vector<Cell> cells;
  for (const Cell& cell : subject.comparison.cells)
    if (cell.replicates > 0) cells.push_back(cell);
  if (cells.empty()) return;
  for (const Cell& cell : cells) {
    names.push_back(subject.label(cell.contender));
    budgets.push_back(subject.runs().budgets[cell.budget]);
    seconds.push_back(cell.seconds.value);
    samples.push_back(cell.samples.value);
    claimed.push_back(100 * cell.claimed_relative_error);
    coverage.push_back(rounded(100 * cell.coverage));
  }
  Table table = named_rows("Every contender at every budget. Intervals hold 95 %, over replicates.",
                           "contender", names);
  table.add_column({"budget"}, budgets);
  table.add_column({"time, s"}, aligned(seconds));
  std::vector<std::string> counts;
  for (const double count : samples) counts.push_back(count_in_words(count));
  table.add_column({"samples"}, counts);
  for (const CellColumn& column : cell_columns) {
    std::vector<std::string> text;
    for (const Cell& cell : cells) {
      Measured value = cell.*column.what;
      value = {column.unit * value.value,
               {column.unit * value.interval.low, column.unit * value.interval.high}};
      text.push_back(with_interval(value));
    }
    table.add_column({column.heading}, text);
  }
  table.add_column({"claimed error, %"}, aligned(claimed));
  table.add_column({"coverage, % of bins"}, coverage);
  write_folded(html, "All measures of all cells", table);
}

}  // namespace

void write_errors(Html& html, const Subject& subject) {
  write_curves(html, subject);
  write_slopes(html, subject);
  write_crossings(html, subject);
  write_profile(html, subject);
  write_cells(html, subject);
}

}  // namespace wander::report
