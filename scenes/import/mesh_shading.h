// How Mitsuba shades a mesh: by normals of its corners, which it computes where the file has none.
//
// Where these are the normals of the triangles, or opposite to them, they only say where the front
// is; elsewhere they are smooth, and the front is where most of them point.
#pragma once

#include <glm/mat4x4.hpp>
#include <string_view>

#include "core/geometry/triangles.h"

namespace wander {

struct MeshShading {
  enum class Normals { flat, smooth };
  enum class Front { outside, inside };  // of the triangles' own normals

  Normals normals = Normals::flat;
  Front front = Front::outside;
};

// Of a mesh that has normals.
MeshShading shading_of(const Triangles& mesh);

// At each point the mean of its triangles' normals, weighted by their angles there where the transform
// puts them [Thürmer and Wüthrich 1998].  Texture coordinates in an OBJ file part triangles.
Triangles with_computed_normals(Triangles mesh, const glm::dmat4& transform,
                                std::string_view obj_text);
Triangles with_computed_normals(Triangles mesh, const glm::dmat4& transform);

}  // namespace wander
