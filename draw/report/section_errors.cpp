// Error against what it costs: curves, slopes, crossings, and the time to a target.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "draw/report/embedding.h"
#include "draw/report/error_figure.h"
#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"
#include "lab/compare/curves.h"
#include "lab/compare/verdict.h"
#include "lab/wording.h"
#include "statistics/number_text.h"

namespace wander::report {
namespace {

using compare::Crossing;
using compare::Curve;
using compare::Measured;

void write_curves(Html& html, const Subject& subject) {
  const std::vector<Crossing> marked = marked_crossings(subject.comparison);
  std::string caption = fmt::format(
      "Relative root mean square error over replicates against the {} time of a run, seed pass "
      "included; bars are 95 % intervals, and lower left is better. Both axes are logarithmic: "
      "independent samples fall along a slope of −1/2.",
      subject.runs().time == TimeKind::wall ? "wall" : "processor");
  if (!marked.empty())
    caption += " Dashed lines stand where one contender overtakes another for good.";
  if (has_extrapolated(subject.comparison))
    caption +=
        " Dotted lines lead beyond the longest run to open marks: the extrapolated times to the "
        "target error, with their intervals.";
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

// More digits of a slope mean nothing, however near it is to zero.
Measured in_thousandths(const Measured& slope) {
  const auto cut = [](double value) { return std::round(1000 * value) / 1000; };
  return {cut(slope.value), {cut(slope.interval.low), cut(slope.interval.high)}};
}

void write_slopes(Html& html, const Subject& subject) {
  const std::vector<Curve>& curves = subject.comparison.curves;
  if (curves.empty()) return;
  if (subject.runs().budgets.size() < 2)
    html.element("p", "One budget has no slope: two or more show how the error falls.",
                 {{"class", "note"}});
  std::vector<std::string> names, words, target;
  std::vector<Measured> time, samples;
  for (const Curve& curve : curves) {
    names.push_back(subject.label(curve.contender));
    time.push_back(in_thousandths(curve.slope_time));
    samples.push_back(in_thousandths(curve.slope_samples));
    target.push_back(compare::time_to_target(subject.comparison, curve.contender));
    words.push_back(reading(curve));
  }
  Table table = named_rows("Slopes of log error over log cost; independent samples have −1/2.",
                           "contender", names);
  table.add_measured("against time", time);
  table.add_measured("against samples", samples);
  if (subject.comparison.target > 0)
    table.add_column({fmt::format("time to {}", percent(subject.comparison.target)), Kind::words},
                     target);
  table.add_column({"the slope against time", Kind::words}, words);
  write_table(html, table);
}

std::string in_words(const Subject& subject, const Crossing& crossing) {
  const std::string chance = std::isfinite(crossing.p_value)
                                 ? fmt::format(", p = {}", number_text(crossing.p_value, 2))
                                 : std::string();
  std::string text = compare::standing(subject.comparison, crossing) + chance;
  if (!crossing.significant) return text + ".";
  if (std::isfinite(crossing.speedup.value))
    text += fmt::format("; the mean square error of {} is {} times as large",
                        subject.label(crossing.behind),
                        compare::number_with_interval(crossing.speedup));
  if (std::isfinite(crossing.efficiency.value))
    text +=
        fmt::format(", {} times at equal time", compare::number_with_interval(crossing.efficiency));
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
      fmt::format(
          "The share of replicates whose error has come down to {} within a time: "
          "farther left is faster, and a steep rise means that seeds agree. What the "
          "shortest run of a contender has already reached stands at its time, and may "
          "have been there earlier. Where errors fall as the inverse root of time (the slope "
          "does not differ from −1/2), the time of a replicate is that of this law through "
          "all of its films, elsewhere it is interpolated between them; so a film near the "
          "target may lie on its other side. Dotted, with "
          "open marks, is what is extrapolated beyond the longest run of a contender, up "
          "to {} times that run. A curve that stays below 100 % belongs to a contender of "
          "which some replicates do not come there.",
          percent(target), compare::farthest));
}

struct CellColumn {
  const char* heading;
  Measured Cell::*what;
  double unit;
};
constexpr std::array error_columns{
    CellColumn{"relative RMSE, %", &Cell::relative_rmse, 100},
    CellColumn{"median relative RMSE, %", &Cell::median_relative_rmse, 100},
    CellColumn{"RMSE, film units", &Cell::rmse, 1}, CellColumn{"MAE, film units", &Cell::mae, 1},
    CellColumn{"relMSE", &Cell::rel_mse, 1}};
constexpr std::array claim_columns{
    CellColumn{"bias, %", &Cell::bias, 100},
    CellColumn{"error of the mean, %", &Cell::relative_error_of_mean, 100},
    CellColumn{"efficiency, 1/s", &Cell::efficiency, 1}};

std::string in_unit(const Measured& measured, double unit) {
  return with_interval(
      {unit * measured.value, {unit * measured.interval.low, unit * measured.interval.high}});
}

// Contender, budget, and these columns.
Table cell_table(const Subject& subject, const std::vector<Cell>& cells, std::string caption,
                 std::span<const CellColumn> columns) {
  std::vector<std::string> names, budgets;
  for (const Cell& cell : cells) {
    names.push_back(subject.label(cell.contender));
    budgets.push_back(subject.runs().budgets[cell.budget]);
  }
  Table table = named_rows(std::move(caption), "contender", names);
  table.add_column({"budget"}, budgets);
  for (const CellColumn& column : columns) {
    std::vector<std::string> text;
    for (const Cell& cell : cells) text.push_back(in_unit(cell.*column.what, column.unit));
    table.add_column({column.heading}, text);
  }
  return table;
}

// Two tables: the columns of one would not fit a page of paper.
void write_cells(Html& html, const Subject& subject) {
  std::vector<std::string> coverage, samples;
  std::vector<double> seconds, claimed;
  std::vector<Cell> cells;
  for (const Cell& cell : subject.comparison.cells)
    if (cell.replicates > 0) cells.push_back(cell);
  if (cells.empty()) return;
  for (const Cell& cell : cells) {
    seconds.push_back(cell.seconds.value);
    samples.push_back(count_in_words(cell.samples.value));
    claimed.push_back(100 * cell.claimed_relative_error);
    coverage.push_back(rounded(100 * cell.coverage));
  }
  write_folded(html, "The errors of all cells, in figures",
               cell_table(subject, cells,
                          "Every contender at every budget. Intervals hold 95 %, over replicates.",
                          error_columns));
  Table claims = cell_table(
      subject, cells, "Cost, bias and claims of every contender at every budget; 95 % intervals.",
      claim_columns);
  claims.add_column({"time, s"}, aligned(seconds));
  claims.add_column({"samples"}, samples);
  claims.add_column({"claimed error, %"}, aligned(claimed));
  claims.add_column({fmt::format("coverage, % of {}", subject.bins())}, coverage);
  write_folded(html, "Cost, bias and claims of all cells, in figures", claims);
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
