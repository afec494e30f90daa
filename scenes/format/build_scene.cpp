#include "scenes/format/build_scene.h"

#include <cmath>
#include <numbers>

#include "core/requirements.h"

namespace wander {

namespace {

constexpr double smooth_below = 1e-8;    // roughness
constexpr double matched_below = 1e-12;  // |η - 1|
constexpr double full_turn = 2 * std::numbers::pi;

template <World W>
typename W::Point point(const description::Coordinates& c) {
  return {c[0] + 0.0, c[1] + 0.0};  // -0 is 0
}

double grey(const description::Quantity& q) { return q.channels[0]; }

// As the world holds them: float knows fewer of them apart.
template <class Real>
bool indices_match(Real a, Real b) {
  return std::abs(a / b - 1) < matched_below;
}

// Adds shapes that share a material, a light and a sensor.
template <World W>
struct PartAdder {
  SceneParts<W>& parts;
  std::size_t material;
  typename W::Real radiance;
  bool is_sensor;

  void add(Shape<W> shape) { parts.parts.push_back({shape, material, radiance, is_sensor}); }

  void operator()(const description::Segment& s) {
    add(Segment<W>(point<W>(s.from), point<W>(s.to)));
  }
  void operator()(const description::Polyline& s) {
    for (std::size_t i = 0; i + 1 < s.points.size(); ++i)
      add(Segment<W>(point<W>(s.points[i]), point<W>(s.points[i + 1])));
    if (s.closed) add(Segment<W>(point<W>(s.points.back()), point<W>(s.points.front())));
  }
  void operator()(const description::Circle& s) {
    add(Arc<W>(point<W>(s.center), s.radius, 0, full_turn, facing(s.flip)));
  }
  void operator()(const description::Arc& s) {
    double extent = s.to_degrees - s.from_degrees;
    while (extent <= 0) extent += 360;
    const double radian = std::numbers::pi / 180;
    const double turn = extent >= 360 ? full_turn : extent * radian;
    add(Arc<W>(point<W>(s.center), s.radius, s.from_degrees * radian, turn, facing(s.flip)));
  }
  static typename Arc<W>::Facing facing(bool flipped) {
    return flipped ? Arc<W>::Facing::inward : Arc<W>::Facing::outward;
  }
};

template <World W>
Camera<W> build_camera(const description::Camera& c) {
  const typename W::Point offset = point<W>(c.target) - point<W>(c.position);
  const typename W::Point axis = glm::normalize(offset);
  const double half = std::tan(c.fov_degrees * std::numbers::pi / 360);
  return {.position = point<W>(c.position),
          .axis = axis,
          .across = {-left_of(axis)},  // bin 0 is leftmost
          .extent = {2 * half},
          .lens_radius = c.aperture_radius,
          .focus_distance = c.focus_distance.value_or(glm::length(offset))};
}

}  // namespace

template <World W>
struct MaterialBuilder {
  using Real = typename W::Real;
  static Real real(double x) { return static_cast<Real>(x); }
  static Real grey(const description::Quantity& q) { return real(wander::grey(q)); }

  Material<W> operator()(const description::Black&) const { return Black<W>{}; }
  Material<W> operator()(const description::Diffuse& m) const {
    return grey(m.reflectance) > 0 ? Material<W>(Diffuse<W>{grey(m.reflectance)}) : Black<W>{};
  }
  Material<W> operator()(const description::Mirror& m) const {
    return grey(m.reflectance) > 0 ? Material<W>(Mirror<W>{grey(m.reflectance)}) : Black<W>{};
  }
  Material<W> operator()(const description::Dielectric& m) const {
    return Dielectric<W>{real(m.interior_index), real(m.exterior_index)};
  }
  Material<W> operator()(const description::RoughConductor& m) const {
    if (!(grey(m.reflectance) > 0)) return Black<W>{};
    if (m.roughness < smooth_below) return Mirror<W>{grey(m.reflectance)};
    return RoughConductor<W>{real(m.roughness), grey(m.reflectance)};
  }
  Material<W> operator()(const description::RoughDielectric& m) const {
    const Real interior = real(m.interior_index), exterior = real(m.exterior_index);
    if (m.roughness < smooth_below || indices_match(interior, exterior))
      return Dielectric<W>{interior, exterior};
    return RoughDielectric<W>{real(m.roughness), interior, exterior};
  }
};

template <World W>
Material<W> build_material(const description::MaterialKind& kind) {
  return std::visit(MaterialBuilder<W>{}, kind);
}

template <World W>
std::unique_ptr<const Scene<W>> build_flatland(const description::Scene& scene) {
  SceneParts<W> parts;
  parts.max_vertices = scene.max_vertices;
  parts.resolution = film_shape(scene);
  for (const auto& m : scene.materials) parts.materials.push_back(build_material<W>(m.kind));
  const std::size_t black = parts.materials.size();
  parts.materials.push_back(Black<W>{});
  for (const auto& shape : scene.shapes) {
    const double radiance = shape.light ? grey(shape.light->radiance) : 0;
    PartAdder<W> adder{parts, shape.material.value_or(black),
                       static_cast<typename W::Real>(radiance), shape.sensor.has_value()};
    std::visit(adder, shape.kind);
  }
  if (scene.camera) parts.camera = build_camera<W>(*scene.camera);
  return std::make_unique<const Scene<W>>(std::move(parts));
}

template std::unique_ptr<const Scene<Flatland>> build_flatland(const description::Scene&);
template std::unique_ptr<const Scene<FlatlandSingle>> build_flatland(const description::Scene&);
template Material<Flatland> build_material<Flatland>(const description::MaterialKind&);
template Material<FlatlandSingle> build_material<FlatlandSingle>(const description::MaterialKind&);
template Material<Spaceland> build_material<Spaceland>(const description::MaterialKind&);

}  // namespace wander
