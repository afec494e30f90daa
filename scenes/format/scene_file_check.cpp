#include "scenes/format/scene_file_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_build.h"
#include "scenes/format/scene_file_nearest.h"
#include "scenes/format/scene_textures.h"

namespace wander {

namespace {

using description::Coordinates;
using description::shortest_length;

constexpr int most_pixels = 100'000'000;

class Check {
 public:
  Check(const JsonDocument& document, const std::vector<JsonFault>& faults,
        const std::set<std::string>& meant)
      : document_(document), meant_(meant), knows_all_(faults.size() <= json_limits.faults) {
    for (const JsonFault& fault : faults) fault_bytes_.insert(fault.byte);
  }

  std::vector<JsonFault> of_document() &&;

 private:
  void check_materials(const std::vector<JsonMember>& shapes);
  void check_reference(JsonNode shape, JsonNode reference);
  void check_counts(JsonNode list, const std::vector<JsonMember>& shapes);
  void check_geometry(const std::vector<JsonMember>& shapes);
  void check_camera();
  void check_pixels(JsonNode holder);
  void check_up(JsonNode camera, const Coordinates& view);

  void note(JsonNode shape, const description::Flaws& flaws);

  bool is_faulty(JsonNode node) const {
    const auto found = fault_bytes_.lower_bound(document_.byte_of(node));
    return found != fault_bytes_.end() && document_.holds_byte(node, *found);
  }
  bool is_full() const { return faults_.size() > json_limits.faults; }
  bool has_dimension(int dimension) const {
    const auto found = document_.find(document_.root(), "dimension");
    return found && *found->value == dimension;
  }
  void note(JsonNode node, std::string what) {
    if (!is_full()) faults_.push_back(document_.fault(node, std::move(what)));
  }
  // In a place that is known to be valid.
  JsonNode at(JsonNode object, std::string_view key) const { return *document_.find(object, key); }

  const JsonDocument& document_;
  const std::set<std::string>& meant_;
  const bool knows_all_;  // else a shape without a known fault may yet be invalid
  std::set<std::size_t> fault_bytes_;
  std::unordered_map<std::string, std::string> material_types_;  // by name
  std::vector<std::string> material_names_;
  std::vector<JsonFault> faults_;
};

std::vector<JsonFault> Check::of_document() && {
  check_camera();
  const auto list = document_.find(document_.root(), "shapes");
  if (list && (*list)->is_array()) {
    const std::vector<JsonMember> shapes = document_.children(*list);
    check_materials(shapes);
    check_counts(*list, shapes);
    if (knows_all_) check_geometry(shapes);
  }
  return std::move(faults_);
}

void Check::check_materials(const std::vector<JsonMember>& shapes) {
  const auto materials = document_.find(document_.root(), "materials");
  if (materials && !(*materials)->is_object()) return;  // nobody knows what names it would have
  if (materials)
    for (const JsonMember& material : document_.children(*materials)) {
      const auto type = document_.find(material.node, "type");
      const bool is_text = type && (*type)->is_string();
      material_names_.emplace_back(material.key);
      material_types_.emplace(material.key, is_text ? (*type)->get<std::string>() : "");
    }
  for (const JsonMember& shape : shapes) {
    const auto reference = document_.find(shape.node, "material");
    if (reference && (*reference)->is_string() && !document_.is_spoiled(*reference) && !is_full())
      check_reference(shape.node, *reference);
  }
}

// Light enters and leaves a dielectric on both sides, where no Lambertian light can lie.
void Check::check_reference(JsonNode shape, JsonNode reference) {
  const auto name = reference->get<std::string>();
  const auto found = material_types_.find(name);
  if (found == material_types_.end()) {
    note(reference,
         material_names_.empty()
             ? fmt::format("\"{}\" is not known; the scene has no \"materials\"", excerpt(name))
             : fmt::format("there is no material \"{}\"; {}", excerpt(name),
                           suggestion(name, material_names_)));
    return;
  }
  const auto kind = document_.find(shape, "type");
  if (has_texture(document_, name) && kind &&
      (*kind->value == "triangle" || *kind->value == "sphere"))
    note(reference, fmt::format("\"{}\" has a texture, and a {} no texture coordinates; a texture "
                                "lies on a parallelogram or a mesh",
                                excerpt(name), (*kind)->get<std::string>()));
  const std::string& type = found->second;
  if (type != "dielectric" && type != "rough_dielectric") return;
  for (const char* role : {"light", "sensor"})
    if (const auto member = document_.find(shape, role))
      note(*member,
           fmt::format("a {} cannot lie on the {} \"{}\"; give it an opaque material, or none",
                       role, type, excerpt(name)));
}

// A camera counts as a sensor; the first in the order of the file is the one that may stay.
void Check::check_counts(JsonNode list, const std::vector<JsonMember>& shapes) {
  std::vector<JsonNode> sensors;
  bool has_light = false;
  for (const JsonMember& shape : shapes) {
    if (const auto sensor = document_.find(shape.node, "sensor")) sensors.push_back(*sensor);
    has_light = has_light || document_.find(shape.node, "light");
  }
  if (const auto camera = document_.find(document_.root(), "camera")) sensors.push_back(*camera);
  if (!has_light && !meant_.contains("light"))
    note(list, "no shape is a light; give one or more a \"light\": { \"radiance\": > 0 }");
  if (sensors.empty() && !meant_.contains("sensor") && !meant_.contains("camera"))
    note(list, "the scene has no sensor; give one shape a \"sensor\", or the scene a \"camera\"");
  if (sensors.size() < 2) return;
  std::sort(sensors.begin(), sensors.end(),
            [](JsonNode a, JsonNode b) { return a.index < b.index; });
  const std::string first = document_.pointer_of(sensors.front());
  for (std::size_t i = 1; i < sensors.size() && !is_full(); ++i)
    note(sensors[i], fmt::format("a sensor too many, after {}; a scene has exactly one sensor or "
                                 "camera",
                                 first));
}

// Of [width, height].
void Check::check_pixels(JsonNode holder) {
  const auto resolution = document_.find(holder, "resolution");
  if (!resolution || !(*resolution)->is_array() || is_faulty(*resolution)) return;
  double pixels = 1;
  for (const nlohmann::ordered_json& side : *resolution->value) pixels *= side.get<double>();
  if (pixels > most_pixels)
    note(*resolution,
         fmt::format("{} pixels are too many; a film has at most {}", pixels, most_pixels));
}

// Only shapes without a fault so far can be built.
void Check::check_geometry(const std::vector<JsonMember>& shapes) {
  for (const JsonMember& shape : shapes) {
    if (is_full()) return;
    if (is_faulty(shape.node)) continue;
    if (const auto sensor = document_.find(shape.node, "sensor")) check_pixels(*sensor);
    note(shape.node, std::visit([](const auto& kind) { return kind.flaws(); },
                                build_shape_kind(*shape.node.value)));
  }
}

void Check::note(JsonNode shape, const description::Flaws& flaws) {
  std::string_view listed;
  std::vector<JsonMember> elements;  // of that list
  for (const description::Flaw& flaw : flaws) {
    if (is_full()) return;
    const JsonNode value = at(shape, flaw.key);
    if (flaw.element && listed != flaw.key) {
      elements = document_.children(value);
      listed = flaw.key;
    }
    note(flaw.element ? elements[*flaw.element].node : value, flaw.what);
  }
}

void Check::check_camera() {
  const auto camera = document_.find(document_.root(), "camera");
  if (!camera) return;
  check_pixels(*camera);
  const auto position = document_.find(*camera, "position"),
             target = document_.find(*camera, "target");
  if (!position || !target || is_faulty(*position) || is_faulty(*target)) return;
  if ((has_dimension(3) ? 3u : 2u) != std::min((*position)->size(), (*target)->size())) return;
  const auto apart = [&](std::size_t axis) {
    return position->value->at(axis).get<double>() - target->value->at(axis).get<double>();
  };
  if (*position->value == *target->value)
    note(*target, "position and target are the same point; a camera looks from one to another");
  else if (std::hypot(apart(0), apart(1), has_dimension(3) ? apart(2) : 0) < shortest_length)
    note(*target, "nearer to position than 1e-60, the least length that can be computed with");
  else if (has_dimension(3))
    check_up(*camera, {apart(0), apart(1), apart(2)});
}

Coordinates of_length_one(const Coordinates& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

void Check::check_up(JsonNode camera, const Coordinates& view) {
  const auto up = document_.find(camera, "up");
  if (up && is_faulty(*up)) return;
  const Coordinates y{0, 1, 0};
  const Coordinates direction = up ? (*up)->get<Coordinates>() : y;
  if (description::too_near(direction, {}))
    note(*up, "up has no length; it is the direction that is up in the picture");
  else if (description::is_narrow(of_length_one(direction), of_length_one(view)))
    note(up ? *up : camera, fmt::format("the camera looks along {}; {} \"up\" across the view",
                                        up ? "up" : "y, which is its up unless it says otherwise",
                                        up ? "choose an" : "give it an"));
}

}  // namespace

std::vector<JsonFault> check_scene(const JsonDocument& document,
                                   const std::vector<JsonFault>& faults,
                                   const std::set<std::string>& meant) {
  return Check(document, faults, meant).of_document();
}

}  // namespace wander
