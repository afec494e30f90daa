// Diffuse light transport in the plane, solved without a random number: the oracle for whole films.
//
// Walls are segments that reflect diffusely on both sides (Lambert, ρ/2) and may emit from the
// front.
//   L_1 = Le,   L_{k+1}(y) = ρ/2 · E_k(y),   E_k(x) = ∫ L_k(y) V(x,y) cos θx cos θy / r dl(y).
// A sensor reads E_1 from paths of two vertices, E_2 from paths of three, and so on: mean
// irradiance over each bin, W/m, on the front of the wall.
//
// Method: Nyström on a mesh of Gauss-Legendre elements.  The integral over y runs over the visible
// angular intervals of x, so occlusion is exact, and pieces of an element nearer than their own
// length are bisected.  The mesh breaks where a shadow edge, the line through two wall ends, meets
// a wall [discontinuity meshing, Heckbert 1992], and it is graded towards the ends of other walls;
// thus each element is smooth, convergence is of high order, and the difference between two meshes
// bounds the error of the finer one.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/exact/plane.h"

namespace wander::description {
struct Scene;
}

namespace wander::exact {

struct Wall {
  PlanePoint from, to;
  double reflectance = 0;  // of both sides; 0 is black
  double radiance = 0;     // emitted from the front
  std::size_t bins = 0;    // the front is a sensor of so many equal bins, in order from → to
};

struct RadiosityScene {
  std::vector<Wall> walls;
  int max_vertices = 8;  // of a path, both ends counted; direct light is 2
};

// How finely to mesh.  With the defaults, films of two rooms of 1 × 1 joined by a slit of 0.05 or
// of 0.002 were within 2e-7 of the value in every bin, the square cavity within 1e-10.
struct RadiosityMesh {
  std::size_t nodes = 6;      // Gauss points per element
  double grading = 0.5;       // longest element, in distances to the nearest end of another wall
  double smallest = 0x1p-12;  // elements at a corner, as a part of their wall
};

struct SensorFilm {
  std::size_t wall = 0;
  std::vector<std::vector<double>> by_vertices;  // [vertices - 2][bin]
  std::vector<double> mean_irradiance;           // Σ over the number of vertices, per bin
  std::vector<double> error;                     // absolute, per bin: |fine - coarse mesh|
};

struct RadiositySolution {
  std::vector<SensorFilm> sensors;  // in the order of their walls
  // Mean total irradiance on the front and the back of each reflecting wall (zero for black ones),
  // from paths that end there with at most max_vertices: what energy balances need.
  std::vector<std::array<double, 2>> wall_irradiance;
  std::size_t unknowns = 0;

  // Of a scene with one sensor.  A temporary solution hands its film out by value.
  const SensorFilm& film() const& { return sensors.front(); }
  SensorFilm film() && { return std::move(sensors.front()); }
};

// On two meshes: the finer one's answer, with the difference as its error.
RadiositySolution solve_radiosity(const RadiosityScene& scene, const RadiosityMesh& mesh = {});
// On this mesh alone; `error` stays empty.
RadiositySolution solve_radiosity_once(const RadiosityScene& scene, const RadiosityMesh& mesh);

// Throws std::invalid_argument where a number is outside its domain, or no wall is a sensor.
void require_valid(const RadiosityScene& scene);
std::vector<PlaneSegment> lines_of(const RadiosityScene& scene);

// A whole scene file: segments and polylines, diffuse or black, no camera.  Throws
// std::invalid_argument naming what else it finds.
RadiosityScene radiosity_scene(const description::Scene& scene);

}  // namespace wander::exact
