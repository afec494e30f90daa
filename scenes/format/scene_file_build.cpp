#include "scenes/format/scene_file_build.h"

#include <map>

#include "scenes/format/json_text.h"

namespace wander {

namespace {

using namespace description;
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

// One number per axis of the film.
std::vector<int> resolution(const ordered_json& json) {
  return json.is_array() ? json.get<std::vector<int>>() : std::vector<int>{json.get<int>()};
}

std::array<Coordinates, 3> three_points(const ordered_json& points) {
  return {coordinates(points[0]), coordinates(points[1]), coordinates(points[2])};
}

MaterialKind material_kind(const ordered_json& material) {
  const auto type = material.at("type").get<std::string>();
  const auto number = [&](const char* key) { return material.at(key).get<double>(); };
  const double exterior_index = material.value("exterior_ior", 1.0);
  if (type == "diffuse") return Diffuse{quantity(material.at("reflectance"))};
  if (type == "mirror") return Mirror{quantity(material.at("reflectance"))};
  if (type == "dielectric") return Dielectric{number("ior"), exterior_index};
  if (type == "rough_conductor")
    return RoughConductor{number("roughness"), quantity(material.at("reflectance"))};
  if (type == "rough_dielectric")
    return RoughDielectric{number("roughness"), number("ior"), exterior_index};
  return Black{};
}

Shape build_shape(const ordered_json& json, const std::map<std::string, std::size_t>& materials,
                  const SceneMeshes& meshes) {
  Shape shape;
  shape.kind = build_shape_kind(json);
  if (auto* mesh = std::get_if<Mesh>(&shape.kind)) mesh->triangles = meshes.of(json);
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

}  // namespace

ShapeKind build_shape_kind(const ordered_json& shape) {
  const auto type = shape.at("type").get<std::string>();
  const auto number = [&](const char* key) { return shape.at(key).get<double>(); };
  if (type == "segment") return Segment{coordinates(shape.at("from")), coordinates(shape.at("to"))};
  const bool flip = shape.value("flip", false);
  if (type == "circle") return Circle{coordinates(shape.at("center")), number("radius"), flip};
  if (type == "arc")
    return Arc{coordinates(shape.at("center")), number("radius"), number("from_deg"),
               number("to_deg"), flip};
  if (type == "sphere") return Sphere{coordinates(shape.at("center")), number("radius"), flip};
  if (type == "triangle") return Triangle{three_points(shape.at("points"))};
  if (type == "parallelogram") {
    const ordered_json& edges = shape.at("edges");
    return Parallelogram{coordinates(shape.at("origin")),
                         {coordinates(edges[0]), coordinates(edges[1])}};
  }
  if (type == "mesh") return Mesh{shape.at("file").get<std::string>(), nullptr};
  Polyline polyline{{}, shape.value("closed", false)};
  polyline.points.reserve(shape.at("points").size());
  for (const ordered_json& point : shape.at("points"))
    polyline.points.push_back(coordinates(point));
  return polyline;
}

Scene build_description(const JsonDocument& document, std::string_view text,
                        const SceneMeshes& meshes) {
  const ordered_json& root = *document.root().value;
  Scene scene;
  scene.name = root.value("name", "");
  scene.description = root.value("description", "");
  scene.dimension = root.at("dimension").get<int>();
  scene.max_vertices = root.value("max_vertices", scene.max_vertices);

  std::map<std::string, std::size_t> materials;  // by name
  if (root.contains("materials"))
    for (const auto& [name, material] : root.at("materials").items()) {
      materials.emplace(name, scene.materials.size());
      scene.materials.push_back({name, material_kind(material)});
    }

  Places places(text);
  for (const JsonMember& member : document.children(*document.find(document.root(), "shapes"))) {
    Shape shape = build_shape(*member.node.value, materials, meshes);
    const Place place = places.of(document.byte_of(member.node));
    shape.line = place.line;
    shape.column = place.column;
    scene.shapes.push_back(std::move(shape));
  }
  if (root.contains("camera")) scene.camera = build_camera(root.at("camera"));
  return scene;
}

}  // namespace wander
