#include "scenes/format/build_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/requirements.h"

namespace wander {

namespace {

constexpr double smooth_below = 1e-8;    // roughness
constexpr double matched_below = 1e-12;  // |η - 1|

template <World W>
typename W::Tint tint(const description::Quantity& q) {
  return q.coloured && !q.texture ? W::Tint::of(q.channels) : typename W::Tint{};
}

// As the world holds them: float knows fewer of them apart.
template <class Real>
bool indices_match(Real a, Real b) {
  return std::abs(a / b - 1) < matched_below;
}

// In the order of film coordinates: to the right, and in space down.
template <World W>
auto film_axes(const description::Camera& c, typename W::Direction axis)
    -> std::array<typename W::Direction, W::dimension - 1> {
  if constexpr (W::dimension == 2) {
    return {-left_of(axis)};
  } else {
    const auto right = glm::normalize(glm::cross(axis, glm::normalize(point_of<W>(c.up))));
    return {right, glm::cross(axis, right)};
  }
}

template <World W>
Camera<W> build_camera(const description::Camera& c) {
  const typename W::Point offset = point_of<W>(c.target) - point_of<W>(c.position);
  const typename W::Point axis = glm::normalize(offset);
  const double width = 2 * std::tan(c.fov_degrees * std::numbers::pi / 360);
  Camera<W> camera{.position = point_of<W>(c.position),
                   .axis = axis,
                   .across = film_axes<W>(c, axis),
                   .extent = {width},
                   .lens_radius = c.aperture_radius,
                   .focus_distance = c.focus_distance.value_or(glm::length(offset))};
  for (std::size_t k = 1; k < camera.extent.size(); ++k)  // pixels are square
    camera.extent[k] = width * c.resolution[k] / c.resolution[0];
  return camera;
}

}  // namespace

template <World W>
struct MaterialBuilder {
  using Real = typename W::Real;
  static Real real(double x) { return static_cast<Real>(x); }
  // What a texture is to scale is 1, unless there is nothing in it.
  static Real grey(const description::Quantity& q) {
    return q.texture && luminance(q) > 0 ? Real(1) : real(luminance(q));
  }

  Material<W> operator()(const description::Black&) const { return Black<W>{}; }
  Material<W> operator()(const description::Diffuse& m) const {
    return grey(m.reflectance) > 0
               ? Material<W>(Diffuse<W>{grey(m.reflectance), tint<W>(m.reflectance)})
               : Black<W>{};
  }
  Material<W> operator()(const description::Mirror& m) const {
    return grey(m.reflectance) > 0
               ? Material<W>(Mirror<W>{grey(m.reflectance), tint<W>(m.reflectance)})
               : Black<W>{};
  }
  Material<W> operator()(const description::Dielectric& m) const {
    return Dielectric<W>{real(m.interior_index), real(m.exterior_index)};
  }
  Material<W> operator()(const description::RoughConductor& m) const {
    if (!(grey(m.reflectance) > 0)) return Black<W>{};
    if (m.roughness < smooth_below) return Mirror<W>{grey(m.reflectance), tint<W>(m.reflectance)};
    return RoughConductor<W>{real(m.roughness), grey(m.reflectance), tint<W>(m.reflectance)};
  }
  Material<W> operator()(const description::RoughDielectric& m) const {
    const Real interior = real(m.interior_index), exterior = real(m.exterior_index);
    if (m.roughness < smooth_below || indices_match(interior, exterior))
      return Dielectric<W>{interior, exterior};
    return RoughDielectric<W>{real(m.roughness), interior, exterior};
  }
  Material<W> operator()(const description::Conductor& m) const { return conductor(m.eta, m.k); }
  Material<W> operator()(const description::RoughMetal& m) const {
    if (m.roughness < smooth_below) return conductor(m.eta, m.k);
    const ComplexIndex<W> index(constants(m.eta), constants(m.k));
    return index.reflected(1).value > 0 ? Material<W>(RoughMetal<W>{real(m.roughness), index})
                                        : Black<W>{};
  }

  static Material<W> conductor(const description::Quantity& eta, const description::Quantity& k) {
    const ComplexIndex<W> index(constants(eta), constants(k));
    return index.reflected(1).value > 0 ? Material<W>(Conductor<W>{index}) : Black<W>{};
  }
  static typename ComplexIndex<W>::Constants constants(const description::Quantity& q) {
    if constexpr (W::channels == 1)
      return {grey(q)};
    else
      return {real(q.channels[0]), real(q.channels[1]), real(q.channels[2])};
  }
};

template <World W>
Material<W> build_material(const description::MaterialKind& kind) {
  return std::visit(MaterialBuilder<W>{}, kind);
}

static std::shared_ptr<const Texture> texture_of(const description::MaterialKind& kind) {
  return std::visit(
      [](const auto& material) -> std::shared_ptr<const Texture> {
        if constexpr (requires { material.reflectance; })
          return material.reflectance.texture;
        else
          return nullptr;
      },
      kind);
}

// What rays meet of a shape.
template <World W, class Add>
void add_parts(const description::Shape& shape, Add&& add) {
  description::visit_kind<W::dimension>(
      [&](const auto& kind) {
        if constexpr (W::dimension == 2)
          add_curves<W>(kind, add);
        else
          add_surfaces<W>(kind, shape.light ? SurfaceRole::emitter : SurfaceRole::passive, add);
      },
      shape.kind);
}

template <World W>
std::vector<std::size_t> shapes_named(const description::Scene& scene) {
  std::vector<std::size_t> shapes;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i)
    add_parts<W>(scene.shapes[i], [&](const Shape<W>&) { shapes.push_back(i); });
  return shapes;
}

template <World W>
std::unique_ptr<const Scene<W>> build_scene(const description::Scene& scene) {
  SceneParts<W> parts;
  parts.max_vertices = scene.max_vertices;
  parts.resolution = film_resolution(scene);
  for (const auto& m : scene.materials) {
    parts.materials.push_back(build_material<W>(m.kind));
    parts.textures.push_back(texture_of(m.kind));
  }
  const std::size_t black = parts.materials.size();
  parts.materials.push_back(Black<W>{});
  for (const auto& shape : scene.shapes) {
    const description::Quantity radiance =
        shape.light ? shape.light->radiance : description::Quantity{};
    add_parts<W>(shape, [&](Shape<W> made) {
      parts.parts.push_back({std::move(made), shape.material.value_or(black),
                             static_cast<typename W::Real>(luminance(radiance)),
                             shape.sensor.has_value(), tint<W>(radiance)});
    });
  }
  if (scene.camera) parts.camera = build_camera<W>(*scene.camera);
  return std::make_unique<const Scene<W>>(std::move(parts));
}

template std::unique_ptr<const Scene<Flatland>> build_scene(const description::Scene&);
template std::unique_ptr<const Scene<FlatlandSingle>> build_scene(const description::Scene&);
template std::unique_ptr<const Scene<Spaceland>> build_scene(const description::Scene&);
template std::unique_ptr<const Scene<SpacelandColour>> build_scene(const description::Scene&);
template std::vector<std::size_t> shapes_named<Flatland>(const description::Scene&);
template std::vector<std::size_t> shapes_named<Spaceland>(const description::Scene&);
template std::vector<std::size_t> shapes_named<SpacelandColour>(const description::Scene&);
template Material<Flatland> build_material<Flatland>(const description::MaterialKind&);
template Material<FlatlandSingle> build_material<FlatlandSingle>(const description::MaterialKind&);
template Material<Spaceland> build_material<Spaceland>(const description::MaterialKind&);
template Material<SpacelandColour> build_material<SpacelandColour>(
    const description::MaterialKind&);

}  // namespace wander
