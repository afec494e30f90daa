#include "core/exact/radiosity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/exact/radiosity_film.h"
#include "core/exact/radiosity_series.h"

namespace wander::exact {

namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("radiosity: " + what);
}

// Gauss weights turn the irradiance at the nodes into means over each side.
std::vector<std::array<double, 2>> wall_means(const RadiosityScene& scene,
                                              const std::vector<Node>& nodes,
                                              const Series& series) {
  std::vector<std::array<double, 2>> means(scene.walls.size(), {0, 0});
  for (const std::vector<double>& irradiance : series.irradiance)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      means[nodes[i].wall][nodes[i].side == Side::front ? 0 : 1] += nodes[i].weight * irradiance[i];
  return means;
}

}  // namespace

void require_valid(const RadiosityScene& scene) {
  require(scene.max_vertices >= 2, "a path has at least 2 vertices");
  bool has_sensor = false;
  for (const Wall& wall : scene.walls) {
    require(wall.reflectance >= 0 && wall.reflectance <= 1, "a reflectance lies outside [0, 1]");
    require(wall.radiance >= 0 && std::isfinite(wall.radiance), "a radiance is negative");
    has_sensor = has_sensor || wall.bins > 0;
  }
  require(has_sensor, "no wall is a sensor");
}

std::vector<PlaneSegment> lines_of(const RadiosityScene& scene) {
  std::vector<PlaneSegment> lines;
  for (const Wall& wall : scene.walls) lines.push_back({wall.from, wall.to});
  return lines;
}

RadiositySolution solve_radiosity_once(const RadiosityScene& scene, const RadiosityMesh& mesh) {
  require_valid(scene);
  require(mesh.nodes >= 2 && mesh.grading > 0 && mesh.smallest > 0, "no such mesh");
  const Visibility visibility(lines_of(scene));
  const Mesher mesher(scene, visibility, mesh);
  const RadiosityElements elements = make_elements(scene, mesher, mesh);
  const Transport transport(scene, visibility, elements);
  const std::vector<Node> nodes = nodes_of(elements);
  const Series series =
      neumann_series(scene, nodes, rows_of(scene, transport, nodes), emission(scene, nodes));
  const FilmIntegral integral(scene, mesher, transport, series);
  RadiositySolution solution;
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    if (scene.walls[w].bins > 0) solution.sensors.push_back(integral.film_of(w, 0));
  solution.wall_irradiance = wall_means(scene, nodes, series);
  solution.unknowns = nodes.size();
  return solution;
}

RadiositySolution solve_radiosity(const RadiosityScene& scene, const RadiosityMesh& mesh) {
  const RadiosityMesh coarse{std::max<std::size_t>(2, mesh.nodes - 1), 2 * mesh.grading,
                             4 * mesh.smallest};
  const RadiositySolution rough = solve_radiosity_once(scene, coarse);
  RadiositySolution solution = solve_radiosity_once(scene, mesh);
  for (std::size_t s = 0; s < solution.sensors.size(); ++s) {
    SensorFilm& film = solution.sensors[s];
    for (std::size_t b = 0; b < film.mean_irradiance.size(); ++b)
      film.error.push_back(std::abs(film.mean_irradiance[b] - rough.sensors[s].mean_irradiance[b]));
  }
  return solution;
}

}  // namespace wander::exact
