#include "scenes/import/import_mitsuba.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file.h"
#include "scenes/import/plugin.h"
#include "scenes/import/sensor.h"
#include "scenes/import/shapes.h"

namespace wander {

namespace {

using nlohmann::ordered_json;

constexpr int vertices_of_unlimited = 64;
constexpr std::size_t longest_description = 4000;  // bytes

bool is_referred_to(const XmlElement& object, const XmlElement& within) {
  if (within.tag == "ref")
    return object.has("id") && within.attribute("id") == object.attribute("id");
  return std::ranges::any_of(
      within.children, [&](const XmlElement& child) { return is_referred_to(object, child); });
}

class SceneImport {
 public:
  SceneImport(const ImportRequest& request, const XmlScene& scene, Diagnosis& diagnosis)
      : request_(request),
        scene_(scene),
        diagnosis_(diagnosis),
        context_(scene, diagnosis),
        shapes_(context_, request.mesh_folder) {}

  ImportedScene result() && {
    for (const XmlElement& child : scene_.root.children) read(child);
    if (sensor_ == nullptr)
      diagnosis_.fault(scene_.root,
                       "the scene has no sensor; give it one, perspective or thinlens");
    shapes_.look_behind(std::span(&eye_, sensor_ == nullptr ? 0 : 1));
    diagnosis_.require_sound();
    ImportedScene imported;
    imported.text = text();
    imported.approximations = diagnosis_.approximations();
    imported.shapes = shapes_.json().size();
    imported.materials = shapes_.materials().entries().size();
    imported.sources = sources();
    imported.files = std::move(shapes_).files();
    return imported;
  }

 private:
  void read(const XmlElement& child) {
    if (child.tag == "shape") return shapes_.add(child);
    if (child.tag == "sensor") return read_sensor(child);
    if (child.tag == "integrator") return read_integrator(child);
    if (child.tag == "emitter" && child.type() == "area" && is_referred_to(child, scene_.root))
      return;  // it is the shape's
    if (child.tag == "emitter")
      return diagnosis_.inexact(child, fmt::format("the emitter \"{}\"", excerpt(child.type())),
                                "nothing");
    if (child.tag == "medium") return diagnosis_.inexact(child, "a medium", "nothing");
    for (const char* known : {"bsdf", "texture", "alias", "sampler", "film", "rfilter", "spectrum"})
      if (child.tag == known) return;  // others refer to it
    diagnosis_.fault(child,
                     fmt::format("<{}> is not known in a scene; known are shape, sensor, bsdf, "
                                 "texture, emitter, integrator, default, include and alias",
                                 excerpt(child.tag)));
  }

  void read_sensor(const XmlElement& sensor) {
    if (sensor_ != nullptr) return diagnosis_.inexact(sensor, "another sensor", "nothing");
    sensor_ = &sensor;
    ImportedSensor imported = import_sensor(sensor, context_);
    camera_ = std::move(imported.camera);
    eye_ = imported.position;
  }

  // max_depth 1 is emission that is seen, 2 has one bounce: its paths have one vertex more.
  void read_integrator(const XmlElement& element) {
    Plugin integrator(element, context_);
    if (integrator.flag("hide_emitters", false))
      diagnosis_.inexact(integrator.where("hide_emitters"), "hidden emitters", "visible ones");
    if (element.type() == "direct") {
      max_vertices_ = 3;
      return;
    }
    for (const XmlElement* inner : integrator.objects("integrator")) read_integrator(*inner);
    const int depth = integrator.integer("max_depth", -1);
    if (depth == 0 || depth < -1)
      diagnosis_.fault(integrator.where("max_depth"),
                       "a max_depth is > 0, or -1 for paths of any length");
    if (depth > 0) max_vertices_ = std::min(depth, 99999) + 1;
    if (depth > 0 || max_vertices_ != 0) return;
    max_vertices_ = vertices_of_unlimited;
    diagnosis_.note(integrator.where("max_depth"),
                    fmt::format("paths are of any length in Mitsuba; here of at most {} vertices",
                                vertices_of_unlimited));
  }

  std::string description() const {
    const auto said = diagnosis_.approximations();
    std::string text =
        fmt::format("Imported from {}{}{}", printable(request_.file.filename().string()),
                    scene_.version.empty() ? "" : ", Mitsuba ", printable(scene_.version));
    text += said.empty() ? "." : "; not exactly:";
    for (std::size_t i = 0; i < said.size(); ++i) {
      const std::string line = fmt::format(" (line {}) {};", said[i].line, said[i].what);
      if (text.size() + line.size() > longest_description)
        return text + fmt::format(" and {} more.", said.size() - i);
      text += line;
    }
    if (text.ends_with(';')) text.back() = '.';
    return text;
  }

  // One shape or material a line.
  std::string text() const {
    std::string text = "{\n  \"format\": \"wanderlight-scene/1\",\n  \"dimension\": 3,\n";
    const auto member = [&](const char* key, const ordered_json& value) {
      text += fmt::format("  \"{}\": {},\n", key, value.dump());
    };
    if (!request_.name.empty()) member("name", request_.name);
    member("description", description());
    if (max_vertices_ != 0) member("max_vertices", max_vertices_);
    std::string lines;
    for (const auto& [name, material, source] : shapes_.materials().entries())
      lines += fmt::format("{}\n    {}: {}", lines.empty() ? "" : ",", ordered_json(name).dump(),
                           material.dump());
    text += fmt::format("  \"materials\": {{{}\n  }},\n", lines);
    lines.clear();
    for (const ordered_json& shape : shapes_.json())
      lines += fmt::format("{}\n    {}", lines.empty() ? "" : ",", shape.dump());
    text += fmt::format("  \"shapes\": [{}\n  ],\n  \"camera\": {}\n}}\n", lines, camera_.dump());
    return text;
  }

  ImportSources sources() const {
    ImportSources sources;
    sources.scene = scene_.root.place;
    sources.camera = sensor_->place;
    for (std::size_t i = 0; i < shapes_.json().size(); ++i)
      sources.shapes.push_back(shapes_.source(i).place);
    for (const auto& [name, material, source] : shapes_.materials().entries())
      if (source != nullptr) sources.materials.emplace(name, source->place);
    return sources;
  }

  const ImportRequest& request_;
  const XmlScene& scene_;
  Diagnosis& diagnosis_;
  ImportContext context_;
  ImportedShapes shapes_;
  const XmlElement* sensor_ = nullptr;
  ordered_json camera_;
  glm::dvec3 eye_{0};
  int max_vertices_ = 0;  // 0: the file says nothing of paths
};

const XmlPlace& place_of(const std::string& pointer, const ImportSources& sources) {
  const std::size_t end = pointer.find('/', 1);
  const std::string part = pointer.substr(0, end);
  const std::string key =
      end == std::string::npos ? "" : pointer.substr(end + 1, pointer.find('/', end + 1) - end - 1);
  if (part == "/camera") return sources.camera;
  if (part == "/shapes" && !key.empty()) {
    const auto index = static_cast<std::size_t>(std::stoul(key));
    if (index < sources.shapes.size()) return sources.shapes[index];
  }
  if (const auto material = sources.materials.find(key);
      part == "/materials" && material != sources.materials.end())
    return material->second;
  return sources.scene;
}

}  // namespace

ImportedScene import_mitsuba(const ImportRequest& request) {
  Diagnosis diagnosis(request.fidelity);
  const XmlScene scene = load_xml(request.file, request.parameters, diagnosis);
  return SceneImport(request, scene, diagnosis).result();
}

void check_imported(const ImportedScene& scene, const std::filesystem::path& folder) {
  try {
    parse_scene(scene.text, "scene", files_in(folder));
  } catch (const SceneFileError& error) {
    std::vector<ImportFault> faults;
    for (const Fault& fault : error.faults) {
      const XmlPlace& place = place_of(fault.pointer, scene.sources);
      faults.push_back(
          {*place.file, place.line, place.column, place.path,
           fmt::format("what comes of it is no valid scene: {}: {}", fault.pointer, fault.what)});
    }
    throw ImportError(std::move(faults));
  }
}

}  // namespace wander
