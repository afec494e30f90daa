// Transforms of Mitsuba: the first element of a <transform> is done first.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scenes/import/diagnosis.h"

namespace wander {

// By value="x, y, z", or by x, y and z, of which those left out are as given.
glm::dvec3 vector_of(const XmlElement& element, glm::dvec3 otherwise, Diagnosis& diagnosis);

// Mitsuba 3 turns about an axis of length 1, and distorts what is turned about another; 0.6 makes its
// length 1.
enum class RotationAxis { as_given, normalized };

// Columns are glm's; p' = M p.
glm::dmat4 transform_of(const XmlElement& transform, RotationAxis axis, Diagnosis& diagnosis);

}  // namespace wander
