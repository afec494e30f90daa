#include "scenes/import/placing.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "scenes/import/mesh_store.h"

namespace wander::placing {

using nlohmann::ordered_json;

Matrix translation(Vector v) {
  Matrix result(1);
  result[3] = {v, 1};
  return result;
}

Matrix scaling(Vector v) {
  Matrix result(1);
  for (int axis = 0; axis < 3; ++axis) result[axis][axis] = v[axis];
  return result;
}

Vector moved(const Matrix& matrix, Vector p) { return Vector(matrix * glm::dvec4(p, 1)); }

bool mirrors(const Matrix& matrix) { return glm::determinant(glm::dmat3(matrix)) < 0; }

ordered_json json_of(Vector v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }  // -0 is 0

ordered_json rows_of(const Matrix& m) {
  ordered_json rows;
  for (int row = 0; row < 3; ++row)
    rows.push_back({m[0][row] + 0.0, m[1][row] + 0.0, m[2][row] + 0.0, m[3][row] + 0.0});
  return rows;
}

Triangles placed(Triangles mesh, const Matrix& matrix) {
  for (auto& point : mesh.points) {
    const Vector p = moved(matrix, {point[0], point[1], point[2]});
    point = {p.x, p.y, p.z};
  }
  return mirrors(matrix) ? turned_round(std::move(mesh)) : mesh;
}

Triangles parallelogram(Vector origin, Vector a, Vector b) {
  Triangles mesh;
  for (const Vector p : {origin, origin + a, origin + a + b, origin + b})
    mesh.points.push_back({p.x, p.y, p.z});
  mesh.corners = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace wander::placing
