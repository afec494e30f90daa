// From a valid JSON document to plain data.
#pragma once

#include <string_view>

#include "core/description.h"
#include "scenes/format/json_document.h"

namespace wander {

// The document is valid and two-dimensional.
description::Scene build_description(const JsonDocument& document, std::string_view text);

// The geometry of one valid shape, in a document that need not be valid elsewhere.
description::ShapeKind build_shape_kind(const nlohmann::ordered_json& shape);

}  // namespace wander
