// Matrices, and meshes that are put where they say.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "core/geometry/triangles.h"

namespace wander::placing {

using Matrix = glm::dmat4;
using Vector = glm::dvec3;

Matrix translation(Vector v);
Matrix scaling(Vector v);
Vector moved(const Matrix& matrix, Vector p);
bool mirrors(const Matrix& matrix);

nlohmann::ordered_json json_of(Vector v);
// The first three.
nlohmann::ordered_json rows_of(const Matrix& m);

// As scene files do it: a mirror image is turned round.
Triangles placed(Triangles mesh, const Matrix& matrix);
Triangles parallelogram(Vector origin, Vector a, Vector b);

}  // namespace wander::placing
