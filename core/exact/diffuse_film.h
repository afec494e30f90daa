// The exact film of a scene file, where it has one: all surfaces diffuse or black, all shapes
// segments or polylines, no camera, and not too much of it.
#pragma once

#include <cstddef>
#include <vector>

namespace wander::description {
struct Scene;
}

namespace wander::exact {

struct DiffuseFilm {
  std::vector<double> value;  // mean irradiance per bin, W/m
  std::vector<double> error;  // absolute, per bin
  std::size_t unknowns = 0;   // of the linear system
};

// Takes seconds at most.  Throws std::invalid_argument that says why there is none.
DiffuseFilm diffuse_film(const description::Scene& scene);

}  // namespace wander::exact
