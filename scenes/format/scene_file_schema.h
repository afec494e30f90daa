// The text of schema/scene.schema.json, which the build embeds: the program validates with the file
// that ships.
#pragma once

namespace wander {

extern const char* const scene_schema_text;

}  // namespace wander
