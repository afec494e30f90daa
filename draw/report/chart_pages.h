// Charts as figures of a report.
#pragma once

#include <string>

#include "draw/figure/chart.h"
#include "draw/figure/style.h"
#include "draw/report/html.h"

namespace wander::report {

// An SVG document, as wide as a page of paper unless said otherwise.
std::string chart_document(figure::Chart chart, const std::string& title,
                           const std::string& description,
                           double width = figure::style::page_width);

// A chart of many panels in as many figures as fit pages of paper.
void write_panels(Html& html, const figure::Chart& chart, const std::string& title,
                  const std::string& description, const std::string& caption);

}  // namespace wander::report
