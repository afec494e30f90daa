// What a document must be, by a JSON Schema: schema and document are walked together, once, and what
// is wrong is said in words that help.  A document without faults conforms.
//
// The walk knows the part of draft 7 that scene.schema.json uses.  A `description` completes a
// message: "-1 is not allowed; " + "a radiance is > 0".
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scenes/format/json_document.h"

namespace wander {

struct Explanation {
  std::vector<JsonFault> faults;
  // Known keys that unknown ones resemble most: what seems to be missing may be among them.
  std::set<std::string> meant;
};
Explanation explain(const JsonDocument& document, const nlohmann::ordered_json& schema);

}  // namespace wander
