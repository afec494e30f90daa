#include "core/fluence.h"

#include <array>
#include <cmath>

#include "core/build_scene.h"
#include "core/sample_film.h"
#include "core/transport.h"

namespace wander {

namespace {

using Point = PlaneGrid::Point;

struct Bounds {
  Point low, high;

  void include(Point p, double radius) {
    low = glm::min(low, p - radius);
    high = glm::max(high, p + radius);
  }
  void operator()(const description::Segment& s) {
    for (const auto& p : {s.from, s.to}) include({p[0], p[1]}, 0);
  }
  void operator()(const description::Polyline& s) {
    for (const auto& p : s.points) include({p[0], p[1]}, 0);
  }
  void operator()(const description::Circle& s) { include({s.center[0], s.center[1]}, s.radius); }
  void operator()(const description::Arc& s) { include({s.center[0], s.center[1]}, s.radius); }
};

// Light that leaves the scene is seen up to the edge of the grid: a black frame far around both
// ends every ray, and changes nothing else.
description::Scene enclosed(description::Scene scene, const PlaneGrid& grid) {
  Bounds bounds{grid.low(), grid.high()};
  for (const auto& shape : scene.shapes) std::visit(bounds, shape.kind);
  const Point margin = 0.25 * (bounds.high - bounds.low);
  const Point low = bounds.low - margin, high = bounds.high + margin;
  description::Shape frame;
  frame.kind = description::Polyline{
      {{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}}, true};
  scene.shapes.push_back(frame);
  return scene;
}

// One walk from the lights at a time.
class LightTracer {
 public:
  LightTracer(const Scene<Flatland>& scene, const PlaneGrid& grid)
      : transport_(scene, Roulette::by_albedo), grid_(&grid), walk_(scene.max_vertices()) {
    walk_.resize(scene.max_vertices());
  }

  void sample(Rng& rng, SampleFilm& film) {
    transport_.begin_light(walk_, 0, rng);
    double flux = 1;
    for (int i = 0; i + 1 < transport_.max_vertices(); ++i) {
      const double survival = transport_.survival(walk_[i]);
      if (survival < 1 && !(rng.uniform() < survival)) return;
      if (!transport_.extend(walk_, i, Toward::sensor, rng)) return;
      transport_.evaluate(walk_, i);
      const Vertex<Flatland>& v = walk_[i];
      if (i == 0) flux /= v.from_light;
      flux *= v.value * v.geometry / walk_[i + 1].from_light;
      if (!(flux > 0) || !std::isfinite(flux)) return;
      deposit(i, flux, film);
    }
  }

 private:
  // A film multiplies by its number of cells: the contribution is that to the mean over the grid.
  void deposit(int i, double flux, SampleFilm& film) const {
    const double density = flux / (grid_->cell_area() * static_cast<double>(grid_->size()));
    grid_->cross(walk_[i].place.position, walk_[i + 1].place.position,
                 [&](std::size_t cell, double length) {
                   film.add(i + 2, i + 1, static_cast<int>(cell), density * length);
                 });
  }

  Transport<Flatland> transport_;
  const PlaneGrid* grid_;
  Path<Flatland> walk_;
};

}  // namespace

Rendering estimate_fluence(const description::Scene& scene, const PlaneGrid& grid,
                           const Session& session) {
  const auto built = build_flatland(enclosed(scene, grid));
  const std::array<int, 2> shape{grid.rows(), grid.columns()};
  const auto make = [&]() -> FilmSampler {
    return [tracer = LightTracer(*built, grid)](Rng& rng, SampleFilm& film) mutable {
      tracer.sample(rng, film);
    };
  };
  return sample_film("fluence", shape, built->max_vertices(), session, make);
}

}  // namespace wander
