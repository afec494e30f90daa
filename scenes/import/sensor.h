// Mitsuba's sensors as cameras of a scene file.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "scenes/import/import_context.h"

namespace wander {

struct ImportedSensor {
  nlohmann::ordered_json camera;  // null after a fault
  glm::dvec3 position{0};
};

ImportedSensor import_sensor(const XmlElement& sensor, const ImportContext& context);

}  // namespace wander
