#include "core/requirements.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

namespace wander {

namespace description {

namespace {

struct MaterialType {
  std::string operator()(const Black&) const { return "black"; }
  std::string operator()(const Diffuse&) const { return "diffuse"; }
  std::string operator()(const Mirror&) const { return "mirror"; }
  std::string operator()(const Dielectric&) const { return "dielectric"; }
  std::string operator()(const RoughConductor&) const { return "rough_conductor"; }
  std::string operator()(const RoughDielectric&) const { return "rough_dielectric"; }
  std::string operator()(const Conductor&) const { return "conductor"; }
  std::string operator()(const RoughMetal&) const { return "rough_conductor"; }
};

bool is_zero(const Quantity& quantity) {
  return std::all_of(quantity.channels.begin(), quantity.channels.end(),
                     [](double channel) { return channel == 0; });
}

// A conductor of the index of what is outside it swallows all light.
template <class Metal>
bool reflects_nothing(const Metal& metal) {
  return is_zero(metal.k) &&
         std::ranges::all_of(metal.eta.channels, [](double channel) { return channel == 1; });
}

// A mirror that reflects nothing is black.
bool is_specular_kind(const MaterialKind& kind) {
  if (const auto* mirror = std::get_if<Mirror>(&kind)) return !is_zero(mirror->reflectance);
  if (const auto* metal = std::get_if<Conductor>(&kind)) return !reflects_nothing(*metal);
  return std::holds_alternative<Dielectric>(kind);
}

struct Scatters {
  bool operator()(const Black&) const { return false; }
  bool operator()(const Diffuse& m) const { return !is_zero(m.reflectance); }
  bool operator()(const Mirror&) const { return false; }
  bool operator()(const Dielectric&) const { return false; }
  bool operator()(const RoughConductor& m) const { return !is_zero(m.reflectance); }
  bool operator()(const RoughDielectric&) const { return true; }
  bool operator()(const Conductor&) const { return false; }
  bool operator()(const RoughMetal& m) const { return !reflects_nothing(m); }
};

struct IsGlossy {
  bool operator()(const RoughConductor& m) const { return !is_zero(m.reflectance); }
  bool operator()(const RoughDielectric&) const { return true; }
  bool operator()(const RoughMetal& m) const { return !reflects_nothing(m); }
  bool operator()(const auto&) const { return false; }
};

// 1 of what has no lobe.
double lobe_of(const MaterialKind& kind, int dimension) {
  if (is_specular_kind(kind)) return 0;
  return std::visit(
      [&](const auto& m) {
        if constexpr (requires { m.roughness; })
          return IsGlossy{}(m) ? std::pow(m.roughness, dimension - 1) : 1.0;
        else
          return 1.0;
      },
      kind);
}

template <class Property>
bool any_material(const std::vector<MaterialKind>& materials, Property property) {
  return std::ranges::any_of(materials,
                             [&](const MaterialKind& kind) { return std::visit(property, kind); });
}

struct Coloured {
  bool operator()(const Diffuse& m) const { return m.reflectance.coloured; }
  bool operator()(const Mirror& m) const { return m.reflectance.coloured; }
  bool operator()(const RoughConductor& m) const { return m.reflectance.coloured; }
  bool operator()(const Conductor& m) const { return m.eta.coloured || m.k.coloured; }
  bool operator()(const RoughMetal& m) const { return m.eta.coloured || m.k.coloured; }
  bool operator()(const auto&) const { return false; }
};

// Materials that no shape wears are not part of the scene.
std::vector<MaterialKind> materials_in_use(const Scene& scene) {
  std::set<std::size_t> used;
  for (const description::Shape& shape : scene.shapes)
    if (shape.material) used.insert(*shape.material);
  std::vector<MaterialKind> kinds;
  for (const std::size_t index : used) kinds.push_back(scene.materials.at(index).kind);
  return kinds;
}

// A caustic is light, focused by specular surfaces, that falls on a surface which is not: the
// sensor itself (light, specular, sensor) or, seen by a camera, one that scatters (a vertex more).
bool caustics_can_form(const Scene& scene, const std::vector<MaterialKind>& materials) {
  if (std::none_of(materials.begin(), materials.end(), is_specular_kind)) return false;
  if (!scene.camera) return scene.max_vertices >= 3;
  return scene.max_vertices >= 4 && any_material(materials, Scatters{});
}

struct Textured {
  bool operator()(const Diffuse& m) const { return m.reflectance.texture != nullptr; }
  bool operator()(const Mirror& m) const { return m.reflectance.texture != nullptr; }
  bool operator()(const RoughConductor& m) const { return m.reflectance.texture != nullptr; }
  bool operator()(const auto&) const { return false; }
};

bool is_coloured(const Scene& scene, const std::vector<MaterialKind>& materials) {
  return any_material(materials, Coloured{}) ||
         std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const description::Shape& shape) {
           return shape.light && shape.light->radiance.coloured;
         });
}

}  // namespace

}  // namespace description

using description::MaterialKind, description::ShapeKind;

std::vector<int> film_resolution(const description::Scene& scene) {
  const auto sensor = std::ranges::find_if(
      scene.shapes, [](const description::Shape& shape) { return shape.sensor.has_value(); });
  std::vector<int> resolution;
  if (scene.camera)
    resolution = scene.camera->resolution;
  else if (sensor != scene.shapes.end())
    resolution = sensor->sensor->resolution;
  // Files say the width first, films have the fastest axis last.
  std::ranges::reverse(resolution);
  return resolution;
}

std::vector<int> film_shape(const description::Scene& scene) {
  using namespace description;
  std::vector<int> shape = film_resolution(scene);
  if (is_coloured(scene, materials_in_use(scene))) shape.push_back(3);
  return shape;
}

std::string type_of(const ShapeKind& kind) {
  return std::visit([](const auto& shape) { return std::string(shape.name); }, kind);
}

std::string type_of(const MaterialKind& kind) {
  return std::visit(description::MaterialType{}, kind);
}

Requirements requires_of(const description::Scene& scene) {
  using namespace description;
  const std::vector<MaterialKind> materials = materials_in_use(scene);
  std::set<std::string> material_types, shape_types;
  for (const MaterialKind& kind : materials) material_types.insert(type_of(kind));
  for (const description::Shape& shape : scene.shapes) shape_types.insert(type_of(shape.kind));

  Requirements requirements;
  requirements.dimension = scene.dimension;
  requirements.colour_channels = is_coloured(scene, materials) ? 3 : 1;
  requirements.materials.assign(material_types.begin(), material_types.end());
  requirements.shapes.assign(shape_types.begin(), shape_types.end());
  requirements.specular = std::any_of(materials.begin(), materials.end(), is_specular_kind);
  for (const MaterialKind& kind : materials)
    requirements.narrowest_lobe =
        std::min(requirements.narrowest_lobe, lobe_of(kind, scene.dimension));
  requirements.caustic_paths_possible = caustics_can_form(scene, materials);
  requirements.scatters = any_material(materials, Scatters{});
  requirements.glossy = any_material(materials, IsGlossy{});
  requirements.smooth_normals =
      std::ranges::any_of(scene.shapes, [](const description::Shape& shape) {
        const auto* mesh = std::get_if<description::Mesh>(&shape.kind);
        return mesh != nullptr && mesh->normals == MeshNormals::smooth;
      });
  requirements.textures = any_material(materials, Textured{});
  requirements.max_vertices = scene.max_vertices;
  return requirements;
}

}  // namespace wander
