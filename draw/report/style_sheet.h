// How a report looks: one column, light or dark as the reader's system is, black on white in print.
#pragma once

#include <string>

namespace wander::report {

std::string style_sheet();

}  // namespace wander::report
