#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/requirements.h"
#include "lab/wording.h"
#include "mutations/family_settings.h"
#include "statistics/number_text.h"
#include "tools/inspection.h"

namespace wander {

namespace {

using nlohmann::ordered_json;
ordered_json counts_of(const description::Scene& scene) {
  std::map<std::string, int> shapes;
  int lights = 0;
  std::size_t triangles = 0;  // of meshes
  for (const description::Shape& shape : scene.shapes) {
    ++shapes[type_of(shape.kind)];
    if (shape.light) ++lights;
    if (const auto* mesh = std::get_if<description::Mesh>(&shape.kind))
      triangles += mesh->triangles->corners.size();
  }
  ordered_json counts{
      {"shapes", shapes}, {"materials", scene.materials.size()}, {"lights", lights}};
  if (triangles > 0) counts["mesh_triangles"] = triangles;
  return counts;
}

ordered_json film_of(const description::Scene& scene) {
  std::string sensor = "camera";
  for (const description::Shape& shape : scene.shapes)
    if (shape.sensor) sensor = type_of(shape.kind);
  return {{"sensor", sensor}, {"shape", film_shape(scene)}};
}

ordered_json requirements_of(const description::Scene& scene) {
  const Requirements needs = requires_of(scene);
  const MutationChoice choice = choose_mutations(needs);
  ordered_json required{
      {"dimension", needs.dimension}, {"colour_channels", needs.colour_channels},
      {"materials", needs.materials}, {"shapes", needs.shapes},
      {"specular", needs.specular},   {"caustic_paths_possible", needs.caustic_paths_possible},
      {"mutations", choice.taken},    {"left_out", choice.left_out}};
  if (needs.dimension == 3) {
    required["smooth_normals"] = needs.smooth_normals;
    required["textures"] = needs.textures;
  }
  return required;
}

ordered_json json_of(const std::vector<Fault>& faults) {
  ordered_json list = ordered_json::array();
  for (const Fault& fault : faults)
    list.push_back({{"line", fault.line},
                    {"column", fault.column},
                    {"pointer", fault.pointer},
                    {"what", fault.what}});
  return list;
}

std::string words_of(const ordered_json& list) {
  return list.empty() ? "none"
                      : fmt::format("{}", fmt::join(list.get<std::vector<std::string>>(), ", "));
}

std::string counted(const ordered_json& counts) {
  std::vector<std::string> parts;
  for (const auto& [name, count] : counts.items())
    parts.push_back(fmt::format("{} {}", count.get<int>(), name));
  return fmt::format("{}", fmt::join(parts, ", "));
}

const char* yes_or_no(const ordered_json& flag) { return flag.get<bool>() ? "yes" : "no"; }

std::string requires_text(const ordered_json& needs) {
  std::string text = "  it requires\n";
  text += fmt::format("    channels      {}\n", needs["colour_channels"].get<int>());
  text += fmt::format("    materials     {}\n", words_of(needs["materials"]));
  text += fmt::format("    shapes        {}\n", words_of(needs["shapes"]));
  if (needs.value("smooth_normals", false)) text += "    normals       smooth\n";
  if (needs.value("textures", false)) text += "    textures      yes\n";
  text += fmt::format("    specular      {}\n", yes_or_no(needs["specular"]));
  text += fmt::format("    caustics      {}\n",
                      needs["caustic_paths_possible"].get<bool>() ? "possible" : "not possible");
  text += fmt::format("    mutations     {}\n", words_of(needs["mutations"]));
  for (const auto& [name, reason] : needs["left_out"].items())
    text += fmt::format("    left out      {}: {}\n", name, reason.get<std::string>());
  return text;
}

ordered_json json_of(const Probe& probe) {
  return {
      {"index_at_sensor", probe.index_at_sensor ? ordered_json(*probe.index_at_sensor) : nullptr},
      {"samples", probe.samples},
      {"samples_with_light", probe.samples_with_light}};
}

}  // namespace

ordered_json inspect_scene(const SceneDocument& document, const Probe& probe) {
  const description::Scene& scene = document.scene;
  return {{"schema", "wanderlight-inspection/1"},
          {"kind", "scene"},
          {"name", scene.name},
          {"description", scene.description},
          {"sha256", document.digest.text},
          {"files", document.digest.files},
          {"dimension", scene.dimension},
          {"max_vertices", scene.max_vertices},
          {"counts", counts_of(scene)},
          {"film", film_of(scene)},
          {"requires", requirements_of(scene)},
          {"probe", json_of(probe)},
          {"warnings", json_of(document.warnings)}};
}

std::string text_of_scene(const ordered_json& inspection) {
  const auto name = inspection["name"].get<std::string>();
  std::string text = fmt::format("scene {}\n", name.empty() ? "without a name" : name);
  if (const auto about = inspection["description"].get<std::string>(); !about.empty())
    text += fmt::format("  {}\n", about);
  const ordered_json& counts = inspection["counts"];
  const ordered_json& film = inspection["film"];
  text += fmt::format("  dimension       {}\n", inspection["dimension"].get<int>());
  text += fmt::format("  longest paths   {} vertices\n", inspection["max_vertices"].get<int>());
  text += fmt::format("  shapes          {}\n", counted(counts["shapes"]));
  if (counts.contains("mesh_triangles"))
    text += fmt::format("  meshes          {} triangles\n", counts["mesh_triangles"].get<int>());
  text += fmt::format("  lights          {}\n", counts["lights"].get<int>());
  text += fmt::format("  sensor          {}, {}\n", film["sensor"].get<std::string>(),
                      extent_in_words(film["shape"].get<std::vector<int>>()));
  text += fmt::format("  sha256          {}\n", inspection["sha256"].get<std::string>());
  for (const auto& [name, digest] : inspection["files"].items())
    text += fmt::format("                  {}  {}\n", digest.get<std::string>(), name);
  const ordered_json& probe = inspection["probe"];
  text += fmt::format("  light           {} of {} bidirectional samples find some\n",
                      probe["samples_with_light"].get<std::uint64_t>(),
                      probe["samples"].get<std::uint64_t>());
  if (!probe["index_at_sensor"].is_null())
    text += fmt::format("  at the sensor   index of refraction {}\n",
                        number_text(probe["index_at_sensor"].get<double>(), 6));
  return text + requires_text(inspection["requires"]);
}

}  // namespace wander
