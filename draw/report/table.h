// Tables of a report: a caption, headings with units, rows that are named by their first cell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/report/html.h"
#include "draw/report/numbers.h"

namespace wander::report {

// Intervals stand on one line, as numbers do, but begin at the left, as words do.
enum class Kind { number, words, interval };

struct Heading {
  std::string text;  // with the unit
  Kind kind = Kind::number;
};

struct Table {
  std::string caption;
  std::vector<Heading> headings{};
  std::vector<std::vector<std::string>> rows{};

  // A column beside those that are there, one cell for each row.
  void add_column(Heading heading, const std::vector<std::string>& cells);
  // Values, times `unit`, and their intervals; left out where nothing is known.
  void add_measured(const std::string& heading, const std::vector<compare::Measured>& column,
                    double unit = 1);
};

// A table whose rows are named, before its columns.
Table named_rows(std::string caption, std::string heading, const std::vector<std::string>& names);

void write_table(Html& html, const Table& table);
// Behind a line of summary, unfolded by the reader; printed unfolded.
void write_folded(Html& html, std::string_view summary, const Table& table);

}  // namespace wander::report
