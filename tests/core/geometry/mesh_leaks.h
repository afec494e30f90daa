// Rays inside closed meshes, aimed where meshes leak: at corners and along edges, to the last bit,
// from inside and from points of the mesh itself.
#pragma once

#include <optional>

#include "core/geometry/accelerator.h"
#include "tests/core/directions.h"
#include "tests/core/geometry/meshes.h"

namespace wander::test {

class MeshRays {
 public:
  using W = Spaceland;
  using Point = W::Point;

  MeshRays(Triangles mesh, Point center, double scale, Generator& g)
      : mesh_(std::make_shared<const Triangles>(std::move(mesh))),
        shape_(mesh_, Mesh<W>::Role::emitter),
        center_(center),
        scale_(scale),
        g_(g) {}

  Shape<W> shape() const { return shape_; }
  const Triangles& mesh() const { return *mesh_; }

  // None where it would start in the last bits of an edge, or not into the mesh.
  std::optional<Ray<W>> draw() {
    if (g_.uniform() < 0.5) {
      const Point origin = center_ + 0.05 * scale_ * random_direction<3>(g_);
      return Ray<W>{.origin = origin, .direction = aim() - origin};
    }
    const auto start = shape_.sample(random_square<3>(g_));
    Ray<W> ray{.origin = start.position,
               .direction = aim() - start.position,
               .from = Element<W>(0, start.primitive)};
    if (g_.uniform() < 0.5) ray.direction = scattered(start.normal);
    const double cosine = -glm::dot(glm::normalize(ray.direction), start.normal);
    const double rounding =
        8 * std::numeric_limits<double>::epsilon() * (glm::length(center_) + scale_);
    if (!(cosine > 0) || to_edge(start) * cosine < rounding) return {};
    return ray;
  }

 private:
  std::int32_t any_triangle() {
    return static_cast<std::int32_t>(g_.uniform() * static_cast<double>(mesh_->corners.size()));
  }
  // A corner or a point of an edge, or near it.
  Point aim() {
    const std::int32_t triangle = any_triangle();
    const Point a = corner_of(*mesh_, triangle, 0), b = corner_of(*mesh_, triangle, 1);
    const double kind = g_.uniform();
    if (kind < 0.4) return a;
    const Point p = kind < 0.8 ? a + g_.uniform() * (b - a) : a;
    return p + scale_ * std::pow(10, -6 - 11 * g_.uniform()) * random_direction<3>(g_);
  }
  Point scattered(Point normal) {
    const auto local = Dimension<3>::cosine_sample(random_square<3>(g_));
    return Frame<3, double>{-normal}.to_world(local);
  }
  double to_edge(const SurfacePoint<W>& start) const {
    double nearest = scale_;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = corner_of(*mesh_, start.primitive, k),
                  b = corner_of(*mesh_, start.primitive, (k + 1) % 3);
      nearest = std::min(nearest,
                         glm::length(glm::cross(start.position - a, b - a)) / glm::length(b - a));
    }
    return nearest;
  }

  std::shared_ptr<const Triangles> mesh_;
  Mesh<W> shape_;
  Point center_;
  double scale_;
  Generator& g_;
};

struct MeshLeaks {
  int rays = 0, escaped = 0;
};

// `make_hits` makes, of the rays, the function that says whether one hits anything.
template <class MakeHits>
MeshLeaks count_leaks(std::uint64_t seed, int meshes, int rays, MakeHits make_hits) {
  MeshLeaks leaks;
  Generator g(seed);
  for (int i = 0; i < meshes; ++i) {
    const bool is_moved = g.uniform() < 0.5;
    const double scale = is_moved ? std::pow(10, 12 * g.uniform() - 6) : 1;
    const Spaceland::Point center =
        is_moved ? 3 * scale * random_direction<3>(g) : Spaceland::Point(0);
    const int rows = 2 + static_cast<int>(20 * g.uniform());
    const double roughness = g.uniform() < 0.3 ? 0 : 0.5 * g.uniform();
    MeshRays draws(g.uniform() < 0.2 ? box_mesh(center - scale * Spaceland::Point(1, 0.9, 0.6),
                                                center + scale * Spaceland::Point(0.8, 1.1, 1.2))
                                     : ball_mesh(g, rows, roughness, center, scale),
                   center, scale, g);
    const auto hits = make_hits(draws);
    for (int k = 0; k < rays; ++k) {
      const auto ray = draws.draw();
      if (!ray) continue;
      ++leaks.rays;
      if (!hits(*ray)) ++leaks.escaped;
    }
  }
  return leaks;
}

inline auto by_hierarchy(const MeshRays& draws) {
  auto shapes = std::make_shared<std::vector<Shape<Spaceland>>>(1, draws.shape());
  return [shapes, hierarchy = SceneAccelerator<Spaceland>(*shapes)](const Ray<Spaceland>& ray) {
    return bool(hierarchy.closest(ray)) && hierarchy.any(ray);
  };
}

}  // namespace wander::test
