// How Mitsuba shades a mesh: by normals of its corners, which it computes where the file has none.
//
// Where these are the normals of the triangles, or opposite to them, they only say where the front
// is; elsewhere they are smooth, and the front is where most of them point.
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/triangles.h"

namespace wander {

struct MeshShading {
  enum class Normals { flat, smooth };
  enum class Front { outside, inside };  // of the triangles' own normals

  Normals normals = Normals::flat;
  Front front = Front::outside;
  bool is_of_file = false;  // a mirror image turns computed normals round
};

// Of a mesh that was read from this text.
MeshShading shading_of_obj(const Triangles& mesh, std::string_view text);
MeshShading shading_of_ply(const Triangles& mesh,
                           const std::vector<std::array<double, 3>>& normals);

}  // namespace wander
