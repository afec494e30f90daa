#include "scenes/import/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <iterator>

#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/scene_file_nearest.h"
#include "scenes/import/bitmap.h"
#include "scenes/import/mesh_shading.h"
#include "scenes/import/placing.h"
#include "scenes/import/plugin.h"
#include "scenes/import/unit_meshes.h"

namespace wander {

using nlohmann::ordered_json;
using namespace placing;

namespace {

constexpr std::uintmax_t largest_mesh = std::uintmax_t{2} << 30;

}  // namespace

class ShapeReader {
 public:
  explicit ShapeReader(ImportedShapes& shapes) : shapes_(shapes) {}

  void read(const XmlElement& element) {
    for (const auto& [type, read] : kinds())
      if (type == element.type()) {
        Plugin shape(element, shapes_.context_);
        matrix_ = shape.transform("to_world");
        turned_ = shape.flag("flip_normals", false);
        bitmap_ = bitmap_on(element);
        shape.ignore({"silhouette_sampling_weight"});
        if (glm::determinant(glm::dmat3(matrix_)) == 0) {
          diagnosis().fault(shape.where("to_world"), "the transform flattens space");
          matrix_ = decltype(matrix_)(1);  // to tell what else is wrong
        }
        (this->*read)(shape);
        if (json_.is_null()) return;  // what it lacks is told
        finish(shape);
        shape.done();
        return;
      }
    std::vector<std::string> known;
    for (const auto& [type, read] : kinds()) known.emplace_back(type);
    diagnosis().fault(element,
                      fmt::format("the shape \"{}\" is not known; {}", excerpt(element.type()),
                                  suggestion(element.type(), known)));
  }

 private:
  using Read = void (ShapeReader::*)(Plugin&);
  static const std::vector<std::pair<std::string_view, Read>>& kinds();  // by type

  Diagnosis& diagnosis() const { return shapes_.context_.diagnosis; }

  // ---- geometry: into json_, and mesh_ or surface_

  std::optional<PlacedBitmap> bitmap_on(const XmlElement& shape) const {
    for (const XmlElement& child : shape.children)
      if (const XmlElement* object = shapes_.context_.known(child);
          object != nullptr && object->tag == "bsdf")
        return placed_bitmap(*object, shapes_.context_);
    return {};
  }

  void rectangle(Plugin&) {
    if (bitmap_) return textured_rectangle();
    const Vector origin = moved(matrix_, {-1, -1, 0});
    Vector a = 2.0 * Vector(matrix_[0]), b = 2.0 * Vector(matrix_[1]);
    if (mirrors(matrix_) != turned_) std::swap(a, b);
    json_ = {{"type", "parallelogram"},
             {"origin", json_of(origin)},
             {"edges", {json_of(a), json_of(b)}}};
    mesh_ = parallelogram(origin, a, b);
  }

  void textured_rectangle() {
    Triangles mesh = parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    for (const std::array<double, 2> uv : {std::array{0.0, 0.0}, {1, 0}, {1, 1}, {0, 1}})
      mesh.coordinates.push_back(bitmap_->place(uv));
    coordinates_ = MeshCoordinates::of_textures;
    add_mesh(std::move(mesh), "rectangle");
  }

  void cube(Plugin&) { add_mesh(unit_cube(), "cube"); }

  void disk(Plugin& shape) {
    round(shape, "a disk");
    add_mesh(unit_disk(), "disk");
  }

  void cylinder(Plugin& shape) {
    const Vector p0 = shape.point("p0", {0, 0, 0}), p1 = shape.point("p1", {0, 0, 1});
    const double radius = shape.number("radius", 1), length = glm::length(p1 - p0);
    if (!(radius > 0) || !(length > 0))
      return diagnosis().fault(shape.element(), "a cylinder has a radius > 0, and p0 is not p1");
    round(shape, "a cylinder");
    const Vector z = (p1 - p0) / length;
    const Vector x =
        glm::normalize(glm::cross(std::abs(z.x) < 0.5 ? Vector(1, 0, 0) : Vector(0, 1, 0), z));
    Matrix frame(1);
    frame[0] = {x, 0};
    frame[1] = {glm::cross(z, x), 0};
    frame[2] = {z, 0};
    matrix_ = matrix_ * translation(p0) * frame * scaling({radius, radius, length});
    add_mesh(unit_cylinder(), "cylinder");
  }

  void round(Plugin& shape, std::string_view what) const {
    diagnosis().inexact(shape.element(), what, fmt::format("a mesh of {} sides", sides_of_round));
  }

  void sphere(Plugin& shape) {
    const Vector center = shape.point("center", {0, 0, 0});
    const double radius = shape.number("radius", 1);
    if (!(radius > 0)) return diagnosis().fault(shape.where("radius"), "a radius is > 0");
    const bool inwards = mirrors(matrix_) != turned_;
    matrix_ = matrix_ * translation(center) * scaling(Vector(radius));
    const auto [least, most] = std::minmax({length_of(0), length_of(1), length_of(2)});
    const double size = least + (most - least) / 2;
    if (!is_similarity(size)) {
      diagnosis().inexact(shape.element(), "an ellipsoid",
                          fmt::format("a mesh of {} sides", sides_of_round));
      turned_ = inwards;
      return add_mesh(unit_sphere(), "sphere");
    }
    json_ = {{"type", "sphere"}, {"center", json_of(Vector(matrix_[3]))}, {"radius", size}};
    if (inwards) json_["flip"] = true;
    surface_ = placed_sphere(
        Vector(matrix_[3]), size,
        inwards ? PlacedSurface::Enclosure::front_inside : PlacedSurface::Enclosure::front_outside);
  }

  double length_of(int axis) const {
    return std::hypot(matrix_[axis].x, matrix_[axis].y, matrix_[axis].z);
  }

  // Up to the digits of a file.
  bool is_similarity(double size) const {
    constexpr double slack = 1e-5;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        const double product = glm::dot(Vector(matrix_[i]) / size, Vector(matrix_[j]) / size);
        if (!(std::abs(product - (i == j ? 1 : 0)) < slack)) return false;
      }
    return true;
  }

  void add_mesh(Triangles mesh, const std::string& name) {
    if (turned_) mesh = turned_round(std::move(mesh));
    put(shapes_.meshes_.add(ply_of(mesh), name + (turned_ ? "_turned.ply" : ".ply")), mesh);
  }

  void put(const std::string& path, const Triangles& mesh) {
    json_ = {{"type", "mesh"}, {"file", path}};
    if (matrix_ != Matrix(1)) json_["transform"] = rows_of(matrix_);
    if (!mesh.normals.empty()) json_["normals"] = "smooth";
    mesh_ = placed(mesh, matrix_);
  }

  void file_mesh(Plugin& shape) {
    const bool flat = shape.flag("face_normals", false);
    upside_down_ = shape.flag("flip_tex_coords", shape.type() == "obj");
    if (shape.has("shape_index"))
      diagnosis().inexact(shape.where("shape_index"), "one mesh of several", "all of the file");
    if (shape.has("max_smooth_angle"))
      diagnosis().inexact(shape.where("max_smooth_angle"), "normals that end at sharp edges",
                          "those of the file");
    shape.ignore(
        {"flip_uvs", "max_smooth_angle", "collapse", "shape_index", "srgb", "load_materials"});
    const std::string name = shape.text("filename", "");
    const XmlElement& where = shape.where("filename");
    const std::filesystem::path path = shapes_.context_.file(where, name);
    if (path.empty()) return;
    try {
      std::error_code problem;
      if (std::filesystem::file_size(path, problem) > largest_mesh)
        throw MeshFileError(
            fmt::format("the file is too large; a mesh may have {} GiB", largest_mesh >> 30));
      std::ifstream stream(path, std::ios::binary);
      std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      copy({std::move(bytes), path.stem().string(), shape.type()},
           flat ? MeshNormals::flat : MeshNormals::smooth);
    } catch (const MeshFileError& error) {
      diagnosis().fault(where, fmt::format("{}: {}", excerpt(name), error.what()));
    }
  }

  struct MeshBytes {
    std::string bytes, stem, type;  // of the file's name; obj or ply
  };

  // With its texture coordinates, if it has them and there is a use for them.
  Triangles parsed(const MeshBytes& file, MeshNormals normals) {
    const auto parse = file.type == "ply" ? parse_ply : parse_obj;
    if (bitmap_) {
      try {
        Triangles mesh = parse(file.bytes, {normals, MeshCoordinates::of_textures});
        coordinates_ = MeshCoordinates::of_textures;
        return mesh;
      } catch (const MeshFileError&) {
      }
    }
    return parse(file.bytes, normals);
  }

  // Are the coordinates in the file those that the picture has here?
  bool are_coordinates_kept() const {
    return coordinates_ == MeshCoordinates::none || (upside_down_ && bitmap_->to_uv == Matrix(1));
  }

  // Mitsuba turns triangles, and the normals that it computes of them, round in a mirror; normals of
  // a file say where the front is.
  void copy(MeshBytes file, MeshNormals normals) {
    const bool is_ply = file.type == "ply";
    Triangles mesh = parsed(file, normals);
    if (!are_coordinates_kept())
      for (auto& uv : mesh.coordinates)
        uv = bitmap_->place({uv[0], upside_down_ ? 1 - uv[1] : uv[1]});
    const bool has_normals = !mesh.normals.empty();
    if (!has_normals && normals == MeshNormals::smooth)
      mesh = is_ply ? with_computed_normals(std::move(mesh), matrix_)
                    : with_computed_normals(std::move(mesh), matrix_, file.bytes);
    const MeshShading shading = mesh.normals.empty() ? MeshShading{} : shading_of(mesh);
    const bool inwards =
        turned_ != (has_normals ? shading.front == MeshShading::Front::inside : mirrors(matrix_));
    if (shading.normals == MeshShading::Normals::flat) {
      mesh.normals.clear();
      mesh.normal_corners.clear();
    }
    if (inwards) mesh = turned_round(std::move(mesh));
    if (!inwards && (has_normals || mesh.normals.empty()) && are_coordinates_kept())
      put(shapes_.meshes_.add(std::move(file.bytes), file.stem + "." + file.type), mesh);
    else
      put(shapes_.meshes_.add(ply_of(mesh), file.stem + (inwards                ? "_turned.ply"
                                                         : mesh.normals.empty() ? "_placed.ply"
                                                                                : "_smooth.ply")),
          mesh);
  }

  // ---- what it is made of

  void finish(Plugin& shape) {
    for (const char* tag : {"medium", "subsurface"})
      for (const XmlElement* object : shape.objects(tag))
        diagnosis().inexact(*object, fmt::format("a {}", tag), "nothing");
    const std::optional<Colour> radiance = light_of(shape);
    ImportedMaterial material = material_of(shape, radiance.has_value());
    if (radiance && material.presence == ImportedMaterial::Presence::absent) {
      diagnosis().inexact(shape.element(), "a light that light passes through",
                          "one that does not");
      material = {};
    }
    if (radiance && material.refracts) {
      diagnosis().inexact(shape.element(), "a light on glass", "a light without glass");
      material = {};
    }
    if (material.presence == ImportedMaterial::Presence::absent) return;
    if (!material.name.empty()) json_["material"] = material.name;
    if (radiance) json_["light"] = {{"radiance", wander::json_of(*radiance)}};
    if (const std::string id = shape.element().attribute("id"); !id.empty())
      json_["name"] = printable(id);
    shapes_.json_.push_back(std::move(json_));
    shapes_.sources_.push_back(&shape.element());
    if (!surface_) surface_ = placed_mesh(std::move(mesh_), material.back);
    surface_->back = material.back;
    shapes_.surfaces_.push_back(std::move(*surface_));
  }

  ImportedMaterial material_of(Plugin& shape, bool is_light) {
    const auto bsdfs = shape.objects("bsdf");
    if (bsdfs.size() > 1) diagnosis().fault(*bsdfs[1], "a shape has one bsdf; this is another");
    if (!bsdfs.empty()) return shapes_.materials_.of(*bsdfs.front(), coordinates_);
    return is_light ? ImportedMaterial{} : shapes_.materials_.usual();  // a bare light is black
  }

  std::optional<Colour> light_of(Plugin& shape) {
    const auto emitters = shape.objects("emitter");
    if (emitters.size() > 1)
      diagnosis().fault(*emitters[1], "a shape has one emitter; this is another");
    if (emitters.empty()) return {};
    Plugin emitter(*emitters.front(), shapes_.context_);
    if (emitter.type() != "area") {
      diagnosis().fault(emitter.element(),
                        fmt::format("the emitter \"{}\" is not known on a shape; known "
                                    "is area",
                                    excerpt(emitter.type())));
      return {};
    }
    emitter.ignore({"sampling_weight"});
    const Colour radiance = emitter.radiance("radiance", 1);
    emitter.done();
    if (radiance == Colour{}) return {};  // it is dark
    return radiance;
  }

  ImportedShapes& shapes_;
  Matrix matrix_{1};
  bool turned_ = false;  // flip_normals
  std::optional<PlacedBitmap> bitmap_;
  MeshCoordinates coordinates_ = MeshCoordinates::none;  // that the shape has for it
  bool upside_down_ = false;                             // flip_tex_coords
  ordered_json json_;                                    // null: nothing is imported
  Triangles mesh_;  // in its place; of a sphere there is a surface
  std::optional<PlacedSurface> surface_;
};

const std::vector<std::pair<std::string_view, ShapeReader::Read>>& ShapeReader::kinds() {
  static const std::vector<std::pair<std::string_view, Read>> all{
      {"obj", &ShapeReader::file_mesh},       {"ply", &ShapeReader::file_mesh},
      {"rectangle", &ShapeReader::rectangle}, {"cube", &ShapeReader::cube},
      {"sphere", &ShapeReader::sphere},       {"disk", &ShapeReader::disk},
      {"cylinder", &ShapeReader::cylinder},
  };
  return all;
}

void ImportedShapes::add(const XmlElement& shape) { ShapeReader(*this).read(shape); }

void ImportedShapes::look_behind(std::span<const glm::dvec3> eyes) {
  const std::vector<bool> seen = seen_from_behind(surfaces_, eyes);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i])
      context_.diagnosis.inexact(*sources_[i],
                                 "a surface that is black from behind, where it can be seen,",
                                 "one that is the same from both sides");
}

}  // namespace wander
