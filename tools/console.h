// The two streams of the program: data on stdout, everything else on stderr.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "records/atomic_file.h"

namespace wander {

// Writes all of `text` to stdout or throws OutputError (closed pipe, full disk).
void print_data(std::string_view text);
void print_data(const FileWriter& write);
// One JSON document, indented; numbers that are not finite become null.
void print_json(const nlohmann::ordered_json& document);
nlohmann::ordered_json finite_or_null(double x);  // in JSON

// Text for people, on stderr as it is.  That nobody can read it is no failure.
void print_note(std::string_view text);

bool stderr_is_terminal();

enum class Verbosity { quiet, normal, verbose };
// Log lines go to stderr as `level: text`, in colour on a terminal unless NO_COLOR is set.
void open_log(Verbosity verbosity);
void print_error(std::string_view message);

}  // namespace wander
