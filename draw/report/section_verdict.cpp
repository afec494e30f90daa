// The verdict in words, what warns of it, and the numbers at the budget that decides.
#include <fmt/format.h>

#include <algorithm>

#include "draw/report/numbers.h"
#include "draw/report/sections.h"
#include "draw/report/table.h"

namespace wander::report {
namespace {

// The verdict holds the first of the cautions itself.
std::vector<std::string> warnings_of(const Subject& subject) {
  std::vector<std::string> warnings;
  if (!subject.runs().complete)
    warnings.push_back(
        "The comparison was interrupted: what follows rests on the runs that were made.");
  const auto add = [&](const std::vector<std::string>& more) {
    for (const std::string& warning : more)
      if (std::ranges::find(subject.comparison.verdict, warning) ==
              subject.comparison.verdict.end() &&
          std::ranges::find(warnings, warning) == warnings.end())
        warnings.push_back(warning);
  };
  add(subject.comparison.cautions);
  add(subject.runs().warnings);
  for (std::size_t k = 0; k < subject.contenders(); ++k)
    if (const Rendering* details = subject.details(k))
      for (const std::string& warning : details->warnings)
        add({fmt::format("{}: {}", subject.label(k), warning)});
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

// At the budget that decides, in the order of the ranking.
std::vector<Cell> decisive_cells(const Subject& subject) {
  std::vector<Cell> cells;
  for (const std::size_t contender : subject.comparison.ranking)
    for (const Cell& cell : subject.cells(contender))
      if (cell.budget == subject.comparison.decisive) cells.push_back(cell);
  return cells;
}

void write_numbers(Html& html, const Subject& subject) {
  const std::vector<Cell> cells = decisive_cells(subject);
  if (cells.empty()) return;
  std::vector<std::string> names, coverage;
  std::vector<double> seconds;
  for (const Cell& cell : cells) {
    names.push_back(subject.label(cell.contender));
    seconds.push_back(cell.seconds.value);
    coverage.push_back(rounded(100 * cell.coverage));
  }
  Table table = named_rows(fmt::format("At budget {}, least error first; {}. Errors are "
                                       "relative root mean squares over replicates.",
                                       subject.runs().budgets[subject.comparison.decisive],
                                       counted(subject.runs().replicates, "replicate")),
                           "contender", names);
  table.add_measured("error, %", column_of(cells, &Cell::relative_rmse), 100);
  table.add_measured("of which bias, %", column_of(cells, &Cell::bias), 100);
  table.add_column({"time, s"}, aligned(seconds));
  table.add_measured("1 / (error² · time), 1/s", column_of(cells, &Cell::efficiency));
  table.add_column({"95 % bars that hold, %"}, coverage);
  write_table(html, table);
}

}  // namespace

void write_verdict(Html& html, const Subject& subject) {
  const std::vector<std::string>& verdict = subject.comparison.verdict;
  if (verdict.empty())
    html.element("p", "The runs that were made allow no verdict.");
  else
    write_list(html, verdict, "verdict");
  write_warnings(html, warnings_of(subject));
  write_numbers(html, subject);
}

}  // namespace wander::report
