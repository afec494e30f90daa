#include "core/build_scene.h"

#include <cmath>
#include <numbers>

namespace wander {

namespace {

constexpr double smooth_below = 1e-8;    // roughness
constexpr double matched_below = 1e-12;  // |η - 1|
constexpr double full_turn = 2 * std::numbers::pi;

using Point = Flatland::Point;

Point point(const description::Coordinates& c) { return {c[0] + 0.0, c[1] + 0.0}; }  // -0 is 0

double grey(const description::Quantity& q) { return q.channels[0]; }

bool indices_match(double a, double b) { return std::abs(a / b - 1) < matched_below; }

// Adds shapes that share a material, a light and a sensor.
struct PartAdder {
  SceneParts<Flatland>& parts;
  std::size_t material;
  double radiance;
  bool is_sensor;

  void add(Shape<Flatland> shape) { parts.parts.push_back({shape, material, radiance, is_sensor}); }

  void operator()(const description::Segment& s) {
    add(Segment<Flatland>(point(s.from), point(s.to)));
  }
  void operator()(const description::Polyline& s) {
    for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
      add(Segment<Flatland>(point(s.points[i]), point(s.points[i + 1])));
    if (s.closed) add(Segment<Flatland>(point(s.points.back()), point(s.points.front())));
  }
  void operator()(const description::Circle& s) {
    add(Arc<Flatland>(point(s.center), s.radius, 0, full_turn, facing(s.flip)));
  }
  void operator()(const description::Arc& s) {
    double extent = s.to_degrees - s.from_degrees;
    while (extent <= 0) extent += 360;
    const double radian = std::numbers::pi / 180;
    const double turn = extent >= 360 ? full_turn : extent * radian;
    add(Arc<Flatland>(point(s.center), s.radius, s.from_degrees * radian, turn, facing(s.flip)));
  }
  static Arc<Flatland>::Facing facing(bool flipped) {
    return flipped ? Arc<Flatland>::Facing::inward : Arc<Flatland>::Facing::outward;
  }
};

Camera<Flatland> build_camera(const description::Camera& c) {
  const Point offset = point(c.target) - point(c.position);
  const Point axis = glm::normalize(offset);
  const double half = std::tan(c.fov_degrees * std::numbers::pi / 360);
  return {.position = point(c.position),
          .axis = axis,
          .across = {-left_of(axis)},  // bin 0 is leftmost
          .extent = {2 * half},
          .lens_radius = c.aperture_radius,
          .focus_distance = c.focus_distance.value_or(glm::length(offset))};
}

}  // namespace

template <World W>
struct MaterialBuilder {
  Material<W> operator()(const description::Black&) const { return Black<W>{}; }
  Material<W> operator()(const description::Diffuse& m) const {
    return grey(m.reflectance) > 0 ? Material<W>(Diffuse<W>{grey(m.reflectance)}) : Black<W>{};
  }
  Material<W> operator()(const description::Mirror& m) const {
    return grey(m.reflectance) > 0 ? Material<W>(Mirror<W>{grey(m.reflectance)}) : Black<W>{};
  }
  Material<W> operator()(const description::Dielectric& m) const {
    return Dielectric<W>{m.interior_index, m.exterior_index};
  }
  Material<W> operator()(const description::RoughConductor& m) const {
    if (!(grey(m.reflectance) > 0)) return Black<W>{};
    if (m.roughness < smooth_below) return Mirror<W>{grey(m.reflectance)};
    return RoughConductor<W>{m.roughness, grey(m.reflectance)};
  }
  Material<W> operator()(const description::RoughDielectric& m) const {
    if (m.roughness < smooth_below || indices_match(m.interior_index, m.exterior_index))
      return Dielectric<W>{m.interior_index, m.exterior_index};
    return RoughDielectric<W>{m.roughness, m.interior_index, m.exterior_index};
  }
};

template <World W>
Material<W> build_material(const description::MaterialKind& kind) {
  return std::visit(MaterialBuilder<W>{}, kind);
}

std::unique_ptr<const Scene<Flatland>> build_flatland(const description::Scene& scene) {
  SceneParts<Flatland> parts;
  parts.max_vertices = scene.max_vertices;
  for (const auto& m : scene.materials) parts.materials.push_back(build_material<Flatland>(m.kind));
  const std::size_t black = parts.materials.size();
  parts.materials.push_back(Black<Flatland>{});
  for (const auto& shape : scene.shapes) {
    if (shape.sensor) parts.resolution = shape.sensor->resolution;
    PartAdder adder{parts, shape.material.value_or(black),
                    shape.light ? grey(shape.light->radiance) : 0.0, shape.sensor.has_value()};
    std::visit(adder, shape.kind);
  }
  if (scene.camera) {
    parts.camera = build_camera(*scene.camera);
    parts.resolution = scene.camera->resolution;
  }
  return std::make_unique<const Scene<Flatland>>(std::move(parts));
}

template Material<Flatland> build_material<Flatland>(const description::MaterialKind&);
template Material<Spaceland> build_material<Spaceland>(const description::MaterialKind&);

}  // namespace wander
