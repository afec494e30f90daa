#include "scenes/format/scene_file_build.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include "scenes/format/json_text.h"

namespace wander {

namespace description {

namespace {

using nlohmann::ordered_json;

Coordinates coordinates(const ordered_json& point) {
  Coordinates result{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) result[axis] = point[axis].get<double>();
  return result;
}

// Three equal channels are no colour.
Quantity quantity(const ordered_json& json) {
  if (!json.is_array()) {
    const auto value = json.get<double>();
    return {{value, value, value}, false};
  }
  const auto channels = json.get<std::array<double, 3>>();
  return {channels, channels[0] != channels[1] || channels[1] != channels[2]};
}

Quantity reflectance(const ordered_json& material, const SceneTextures& textures) {
  const ordered_json& json = material.at("reflectance");
  if (!json.is_object()) return quantity(json);
  const auto texture = textures.of(json);
  return {texture->mean(), texture->is_coloured(), texture};
}

// One number per axis of the film.
std::vector<int> resolution(const ordered_json& json) {
  return json.is_array() ? json.get<std::vector<int>>() : std::vector<int>{json.get<int>()};
}

MaterialKind material_kind(const ordered_json& material, const SceneTextures& textures) {
  const auto type = material.at("type").get<std::string>();
  const auto number = [&](const char* key) { return material.at(key).get<double>(); };
  const double exterior_index = material.value("exterior_ior", 1.0);
  if (type == "diffuse") return Diffuse{reflectance(material, textures)};
  if (type == "mirror") return Mirror{reflectance(material, textures)};
  if (type == "dielectric") return Dielectric{number("ior"), exterior_index};
  if (type == "conductor")
    return Conductor{quantity(material.at("eta")), quantity(material.at("k"))};
  if (type == "rough_conductor" && material.contains("eta"))
    return RoughMetal{number("roughness"), quantity(material.at("eta")),
                      quantity(material.at("k"))};
  if (type == "rough_conductor")
    return RoughConductor{number("roughness"), reflectance(material, textures)};
  if (type == "rough_dielectric")
    return RoughDielectric{number("roughness"), number("ior"), exterior_index};
  return Black{};
}

description::Shape build_shape(const ordered_json& json,
                               const std::map<std::string, std::size_t>& materials,
                               const SceneMeshes& meshes) {
  description::Shape shape;
  shape.kind = build_shape_kind(json);
  if (auto* mesh = std::get_if<description::Mesh>(&shape.kind)) mesh->triangles = meshes.of(json);
  if (json.contains("material"))
    shape.material = materials.at(json.at("material").get<std::string>());
  if (json.contains("light")) shape.light = Light{quantity(json.at("light").at("radiance"))};
  if (json.contains("sensor")) {
    const ordered_json& sensor = json.at("sensor");
    shape.sensor = Sensor{resolution(sensor.at(sensor.contains("bins") ? "bins" : "resolution"))};
  }
  shape.name = json.value("name", "");
  shape.id = json.value("id", "");
  return shape;
}

Camera build_camera(const ordered_json& json) {
  Camera camera;
  camera.position = coordinates(json.at("position"));
  camera.target = coordinates(json.at("target"));
  camera.up = json.contains("up") ? coordinates(json.at("up")) : Coordinates{0, 1, 0};
  camera.fov_degrees = json.at("fov_deg").get<double>();
  camera.resolution = resolution(json.at("resolution"));
  camera.aperture_radius = json.value("aperture_radius", 0.0);
  if (json.contains("focus_distance"))
    camera.focus_distance = json.at("focus_distance").get<double>();
  return camera;
}

// ---- the fields of a shape, where they are given

template <class Value>
void read(const ordered_json& json, Value& value) {
  value = json.get<Value>();
}
void read(const ordered_json& value, Coordinates& point) { point = coordinates(value); }
void read(const ordered_json& value, MeshNormals& normals) {
  normals = value == "smooth" ? MeshNormals::smooth : MeshNormals::flat;
}
template <std::size_t count>
void read(const ordered_json& value, std::array<Coordinates, count>& points) {
  std::ranges::transform(value, points.begin(), coordinates);
}
void read(const ordered_json& value, std::vector<Coordinates>& points) {
  points.reserve(value.size());
  for (const ordered_json& point : value) points.push_back(coordinates(point));
}

template <class Kind>
Kind read_fields(const ordered_json& shape) {
  Kind kind;
  const auto read_field = [&](const auto& field) {
    if (const auto found = shape.find(field.key); found != shape.end())
      read(*found, kind.*field.value);
  };
  std::apply([&](const auto&... field) { (read_field(field), ...); }, Kind::fields());
  return kind;
}

// The schema has seen to it that there is one of this name.
template <std::size_t i = 0>
ShapeKind kind_named(std::string_view name, const ordered_json& shape) {
  using Kind = std::variant_alternative_t<i, ShapeKind>;
  if (name == Kind::name) return read_fields<Kind>(shape);
  if constexpr (i + 1 < std::variant_size_v<ShapeKind>)
    return kind_named<i + 1>(name, shape);
  else
    throw std::logic_error("the schema knows a shape that the program does not");
}

}  // namespace

}  // namespace description

description::ShapeKind build_shape_kind(const nlohmann::ordered_json& shape) {
  using namespace description;
  return kind_named(shape.at("type").get_ref<const std::string&>(), shape);
}

description::Scene build_description(const JsonDocument& document, std::string_view text,
                                     const SceneMeshes& meshes, const SceneTextures& textures) {
  using namespace description;
  const ordered_json& root = *document.root().value;
  description::Scene scene;
  scene.name = root.value("name", "");
  scene.description = root.value("description", "");
  scene.dimension = root.at("dimension").get<int>();
  scene.max_vertices = root.value("max_vertices", scene.max_vertices);

  std::map<std::string, std::size_t> materials;  // by name
  if (root.contains("materials"))
    for (const auto& [name, material] : root.at("materials").items()) {
      materials.emplace(name, scene.materials.size());
      scene.materials.push_back({name, material_kind(material, textures)});
    }

  Places places(text);
  for (const JsonMember& member : document.children(*document.find(document.root(), "shapes"))) {
    description::Shape shape = build_shape(*member.node.value, materials, meshes);
    const LineColumn place = places.of(document.byte_of(member.node));
    shape.line = place.line;
    shape.column = place.column;
    scene.shapes.push_back(std::move(shape));
  }
  if (const auto camera = document.find(document.root(), "camera")) {
    scene.camera = build_camera(*camera->value);
    const LineColumn place = places.of(document.byte_of(*camera));
    scene.camera->line = place.line;
    scene.camera->column = place.column;
  }
  return scene;
}

}  // namespace wander
