// From a valid JSON document to plain data.
#pragma once

#include <string_view>

#include "core/description.h"
#include "scenes/format/json_document.h"
#include "scenes/format/scene_meshes.h"
#include "scenes/format/scene_textures.h"

namespace wander {

// The document is valid, and its meshes and textures are read.
description::Scene build_description(const JsonDocument& document, std::string_view text,
                                     const SceneMeshes& meshes, const SceneTextures& textures);

// The geometry of one valid shape, in a document that need not be valid elsewhere; of a mesh its
// file alone.
description::ShapeKind build_shape_kind(const nlohmann::ordered_json& shape);

}  // namespace wander
