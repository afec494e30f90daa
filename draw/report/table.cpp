#include "draw/report/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace wander::report {
namespace {

// Longer tables may go on on the next page of paper.
constexpr std::size_t most_rows_together = 12;

std::string_view class_of(const Heading& heading) {
  switch (heading.kind) {
    case Kind::number:
      return "number";
    case Kind::interval:
      return "interval";
    case Kind::words:
      break;
  }
  return "words";
}

// "[0.1, 0.2]" and ", %" stay on one line.
std::string with_whole_ends(std::string text, std::size_t from) {
  for (auto at = text.find(", ", from); at != std::string::npos; at = text.find(", ", at))
    text.replace(at, 2, ",\u00A0");
  return text;
}

// A unit stays with the word before it.
std::string heading_text(const std::string& text) {
  const std::size_t comma = text.rfind(", ");
  return comma == std::string::npos ? text : with_whole_ends(text, comma);
}

std::string cell_text(const std::string& text, Kind kind) {
  return kind == Kind::words ? text : with_whole_ends(text, 0);
}

void write_row(Html& html, const Table& table, const std::vector<std::string>& row) {
  const auto scope = html.open("tr");
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k == 0)
      html.element("th", row[k], {{"scope", "row"}, {"class", class_of(table.headings[k])}});
    else
      html.element("td", cell_text(row[k], table.headings[k].kind),
                   {{"class", class_of(table.headings[k])}});
  }
}

}  // namespace

void Table::add_column(Heading heading, const std::vector<std::string>& cells) {
  headings.push_back(std::move(heading));
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].push_back(cells[k]);
}

void Table::add_measured(const std::string& heading, const std::vector<compare::Measured>& column,
                         double unit) {
  const MeasuredColumn cells = aligned(column, unit);
  const auto is_known = [](const std::string& cell) { return cell != unknown_number; };
  if (std::ranges::none_of(cells.values, is_known)) return;
  add_column({heading}, cells.values);
  if (std::ranges::any_of(cells.intervals, is_known))
    add_column({"95 % interval", Kind::interval}, cells.intervals);
}

Table named_rows(std::string caption, std::string heading, const std::vector<std::string>& names) {
  Table table{std::move(caption), {{std::move(heading), Kind::words}}, {}};
  for (const std::string& name : names) table.rows.push_back({name});
  return table;
}

void write_table(Html& html, const Table& table) {
  const std::string id = fmt::format("table-{}", html.next_number());
  html.element("p", table.caption, {{"id", id}, {"class", "caption"}});
  // Keys scroll a table that is wider than the page.
  const auto region = html.open(
      "div", {{"class", table.rows.size() <= most_rows_together ? "table short" : "table"},
              {"role", "region"},
              {"tabindex", "0"},
              {"aria-labelledby", id}});
  const auto scope = html.open("table", {{"aria-labelledby", id}});
  {
    const auto head = html.open("thead");
    const auto row = html.open("tr");
    for (const Heading& heading : table.headings)
      html.element("th", heading_text(heading.text),
                   {{"scope", "col"}, {"class", class_of(heading)}});
  }
  const auto body = html.open("tbody");
  for (const auto& row : table.rows) write_row(html, table, row);
}

void write_folded(Html& html, std::string_view summary, const Table& table) {
  const auto scope = html.open("details");
  html.element("summary", summary);
  write_table(html, table);
}

}  // namespace wander::report
