#include "core/exact/diffuse_film.h"

#include <stdexcept>
#include <utility>

#include "core/exact/radiosity_refinement.h"

namespace wander::exact {

namespace {

constexpr std::size_t most_walls = 200;
constexpr int most_vertices = 100;

void require_small(const RadiosityScene& scene) {
  if (scene.walls.size() > most_walls)
    throw std::invalid_argument("more than " + std::to_string(most_walls) + " walls");
  if (scene.max_vertices > most_vertices)
    throw std::invalid_argument("paths of more than " + std::to_string(most_vertices) +
                                " vertices");
}

}  // namespace

DiffuseFilm diffuse_film(const description::Scene& scene) {
  const RadiosityScene walls = radiosity_scene(scene);
  require_small(walls);
  RadiositySolution solution = solve_radiosity_adaptively(walls);
  SensorFilm film = std::move(solution).film();
  return {std::move(film.mean_irradiance), std::move(film.error), solution.unknowns};
}

}  // namespace wander::exact
