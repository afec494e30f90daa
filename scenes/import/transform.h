// Transforms of Mitsuba: the first element of a <transform> is done first.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scenes/import/diagnosis.h"

namespace wander {

// By value="x, y, z", or by x, y and z, of which those left out are as given.
glm::dvec3 vector_of(const XmlElement& element, glm::dvec3 otherwise, Diagnosis& diagnosis);

// Columns are glm's; p' = M p.
glm::dmat4 transform_of(const XmlElement& transform, Diagnosis& diagnosis);

}  // namespace wander
