// The verdict of valijson on a document: what the program says of it is held against this.
#pragma once

#include "scenes/format/json_document.h"

namespace wander::test {

bool conforms(const JsonDocument& document, const char* schema_text);

}  // namespace wander::test
