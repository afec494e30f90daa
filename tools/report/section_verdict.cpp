// The verdict in words, what warns of it, and the numbers at the last budget.
#include <fmt/format.h>

#include <algorithm>

#include "tools/report/numbers.h"
#include "tools/report/sections.h"
#include "tools/report/spread.h"
#include "tools/report/table.h"

namespace wander::report {
namespace {

// Vehtari et al. 2021 ask for less.
constexpr double most_r_hat = 1.01;

void add_chain_warnings(const Subject& subject, std::size_t contender,
                        std::vector<std::string>& warnings) {
  const Rendering& details = *subject.details(contender);
  for (const std::string& warning : details.warnings)
    warnings.push_back(fmt::format("{}: {}", subject.label(contender), warning));
  if (!details.chains_record) return;
  std::vector<std::string> high;
  for (const FunctionalRecord& functional : details.chains_record->functionals)
    if (functional.r_hat > most_r_hat)
      high.push_back(fmt::format("{} {:.3f}", functional.name, functional.r_hat));
  if (!high.empty())
    warnings.push_back(
        fmt::format("{}: the chains do not agree, R-hat is above {} for {}; its error bars may be "
                    "too small.",
                    subject.label(contender), most_r_hat, listed(high)));
}

std::vector<std::string> warnings_of(const Subject& subject) {
  std::vector<std::string> warnings;
  if (!subject.runs().complete)
    warnings.push_back(
        "The comparison was interrupted: what follows rests on the runs that were made.");
  warnings.insert(warnings.end(), subject.runs().warnings.begin(), subject.runs().warnings.end());
  for (std::size_t k = 0; k < subject.contenders(); ++k) {
    const SeedSpread spread = spread_of(subject.replicates(k));
    if (spread.is_wide())
      warnings.push_back(
          fmt::format("{}: seeds lie {:.2g} times as far apart as their error bars claim.",
                      subject.label(k), spread.pooled));
    if (subject.details(k)) add_chain_warnings(subject, k, warnings);
  }
  return warnings;
}

void write_list(Html& html, const std::vector<std::string>& items, std::string_view kind) {
  const auto list = html.open("ul", {{"class", kind}});
  for (const std::string& item : items) html.element("li", item);
}

void write_warnings(Html& html, const std::vector<std::string>& warnings) {
  if (warnings.empty()) return;
  const auto scope =
      html.open("div", {{"class", "warning"}, {"role", "note"}, {"aria-label", "Warnings"}});
  html.element("h3", warnings.size() == 1 ? "Warning" : "Warnings");
  write_list(html, warnings, "warnings");
}

std::vector<compare::Measured> column_of(const std::vector<Cell>& cells,
                                         compare::Measured Cell::*what) {
  std::vector<compare::Measured> column;
  for (const Cell& cell : cells) column.push_back(cell.*what);
  return column;
}

// Of each contender that reached it, in the order of the ranking.
std::vector<Cell> last_cells(const Subject& subject) {
  std::vector<Cell> cells;
  for (const std::size_t contender : subject.comparison.ranking)
    for (const Cell& cell : subject.cells(contender))
      if (cell.budget == subject.last_budget()) cells.push_back(cell);
  return cells;
}

void write_numbers(Html& html, const Subject& subject) {
  const std::vector<Cell> cells = last_cells(subject);
  if (cells.empty()) return;
  std::vector<std::string> names, coverage;
  std::vector<double> seconds;
  for (const Cell& cell : cells) {
    names.push_back(subject.label(cell.contender));
    seconds.push_back(cell.seconds.value);
    coverage.push_back(rounded(100 * cell.coverage));
  }
  Table table = named_rows(
      fmt::format("At the last budget, {}, least error first; {}. Errors are "
                  "relative root mean squares over replicates.",
                  subject.runs().budgets.back(), counted(subject.runs().replicates, "replicate")),
      "contender", names);
  table.add_measured("error, %", column_of(cells, &Cell::relative_rmse), 100);
  table.add_measured("of which bias, %", column_of(cells, &Cell::bias), 100);
  table.add_column({"time, s"}, aligned(seconds));
  table.add_measured("1 / (error² · time), 1/s", column_of(cells, &Cell::efficiency));
  table.add_column({"95 % bars that hold, % of bins"}, coverage);
  write_table(html, table);
}

// Which of the pairs at the last budget chance could have made.
void write_undecided(Html& html, const Subject& subject) {
  std::vector<std::string> pairs;
  for (const compare::Crossing& crossing : subject.comparison.crossings)
    if (!crossing.significant)
      pairs.push_back(
          fmt::format("{} and {}", subject.label(crossing.ahead), subject.label(crossing.behind)));
  if (pairs.empty()) return;
  html.element("p",
               fmt::format("Not significant: at the last budget the errors of {} differ by no more "
                           "than chance may (5 %, all pairs together).",
                           fmt::format("{}", listed(pairs))),
               {{"class", "note"}});
}

}  // namespace

void write_verdict(Html& html, const Subject& subject) {
  const std::vector<std::string>& verdict = subject.comparison.verdict;
  if (verdict.empty())
    html.element("p", "The runs that were made allow no verdict.");
  else
    write_list(html, verdict, "verdict");
  write_warnings(html, warnings_of(subject));
  write_undecided(html, subject);
  write_numbers(html, subject);
}

}  // namespace wander::report
