// How a film that others are held against is named, wherever it is: "exact", where it came from, or
// what made it.
#pragma once

#include <string>

#include "records/run_record.h"

namespace wander {

// The method of the reference.json that `compare` writes; its origin is the first of its warnings.
inline constexpr const char* reference_method_word = "reference";

// Of an origin as compare::Reference has it.
bool is_exact(const std::string& origin);
std::string name_of_reference(const std::string& origin);  // "exact", or the origin itself

// Of a run: "exact", the origin of a reference.json, or "bdpt, 2 M samples".
std::string name_of_reference(const Rendering& rendering);
// Empty unless it is a reference.json.
std::string origin_of(const Rendering& rendering);

}  // namespace wander
