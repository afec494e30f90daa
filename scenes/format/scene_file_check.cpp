#include "scenes/format/scene_file_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <unordered_map>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_build.h"
#include "scenes/format/scene_file_nearest.h"

namespace wander {

namespace {

using namespace description;

bool same_point(const Coordinates& a, const Coordinates& b) { return a == b; }  // -0 is 0

// Squares of shorter lengths are no normal numbers.
constexpr double shortest_length = 1e-150;
constexpr const char* too_short =
    "shorter than 1e-150, the least length that can be computed with; enlarge the scene";
bool too_near(const Coordinates& a, const Coordinates& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < shortest_length;
}

constexpr int most_pixels = 100'000'000;

// Narrower than this share of its longer side, a surface has no normal.
constexpr double least_breadth = 1e-14;
glm::dvec3 vector(const Coordinates& c) { return {c[0], c[1], c[2]}; }
bool is_narrow(const Coordinates& edge, const Coordinates& other) {
  const glm::dvec3 a = vector(edge), b = vector(other);
  const auto largest = glm::max(glm::abs(a), glm::abs(b));
  const double size = std::max({largest.x, largest.y, largest.z});
  return glm::length(glm::cross(a / size, b / size)) < least_breadth;
}
Coordinates difference(const Coordinates& a, const Coordinates& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

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

  void check_shape(JsonNode shape, const Segment& segment);
  void check_shape(JsonNode shape, const Polyline& polyline);
  void check_shape(JsonNode shape, const Circle& circle) { check_radius(shape, circle.radius); }
  void check_shape(JsonNode shape, const Arc& arc);
  void check_shape(JsonNode shape, const Triangle& triangle);
  void check_shape(JsonNode shape, const Parallelogram& parallelogram);
  void check_shape(JsonNode shape, const Sphere& sphere) { check_radius(shape, sphere.radius); }
  void check_shape(JsonNode shape, const Mesh&);
  void check_radius(JsonNode shape, double radius) {
    if (radius < shortest_length) note(at(shape, "radius"), too_short);
  }

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
    std::visit([&](const auto& kind) { check_shape(shape.node, kind); },
               build_shape_kind(*shape.node.value));
  }
}

void Check::check_shape(JsonNode shape, const Segment& segment) {
  if (same_point(segment.from, segment.to))
    note(at(shape, "to"), "from and to are the same point; a segment has a length > 0");
  else if (too_near(segment.from, segment.to))
    note(at(shape, "to"), too_short);
}

void Check::check_shape(JsonNode shape, const Polyline& polyline) {
  const auto& points = polyline.points;
  const std::vector<JsonMember> nodes = document_.children(at(shape, "points"));
  for (std::size_t i = 1; i < points.size() && !is_full(); ++i) {
    if (same_point(points[i], points[i - 1]))
      note(nodes[i].node, "this repeats the point before it; leave one of the two out");
    else if (too_near(points[i], points[i - 1]))
      note(nodes[i].node, too_short);
  }
  if (polyline.closed && same_point(points.front(), points.back()))
    note(nodes.back().node,
         "this repeats the first point; leave it out, for \"closed\" joins the ends");
  else if (polyline.closed && too_near(points.front(), points.back()))
    note(nodes.back().node, too_short);
}

void Check::check_shape(JsonNode shape, const Arc& arc) {
  check_radius(shape, arc.radius);
  if (arc.from_degrees == arc.to_degrees)
    note(at(shape, "to_deg"),
         "from_deg and to_deg are equal; an arc spans > 0 and at most 360 degrees");
  else if (std::abs(arc.to_degrees - arc.from_degrees) > 360)
    note(at(shape, "to_deg"), fmt::format("{} degrees are too many; an arc spans at most 360",
                                          std::abs(arc.to_degrees - arc.from_degrees)));
}

void Check::check_shape(JsonNode shape, const Triangle& triangle) {
  const auto& [a, b, c] = triangle.points;
  const JsonNode list = at(shape, "points");
  const std::vector<JsonMember> nodes = document_.children(list);
  if (same_point(a, b) || same_point(b, c) || same_point(c, a))
    note(nodes[same_point(a, b) ? 1 : 2].node,
         "this repeats a corner; a triangle has three different ones");
  else if (too_near(a, b) || too_near(b, c) || too_near(c, a))
    note(list, too_short);
  else if (is_narrow(difference(b, a), difference(c, a)))
    note(list, "the corners lie on a line; a triangle has an area > 0");
}

void Check::check_shape(JsonNode shape, const Parallelogram& parallelogram) {
  const JsonNode list = at(shape, "edges");
  const std::vector<JsonMember> nodes = document_.children(list);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (too_near(parallelogram.edges[i], {})) {
      note(nodes[i].node, same_point(parallelogram.edges[i], {})
                              ? "this edge has no length; a parallelogram has an area > 0"
                              : too_short);
      return;
    }
  if (is_narrow(parallelogram.edges[0], parallelogram.edges[1]))
    note(list, "the edges are parallel; a parallelogram has an area > 0");
}

void Check::check_shape(JsonNode shape, const Mesh&) {
  const auto transform = document_.find(shape, "transform");
  if (!transform) return;
  const nlohmann::ordered_json& rows = *transform->value;
  const std::array<double, 4> last{0, 0, 0, 1};
  if (rows.size() == 4 && rows[3].get<std::array<double, 4>>() != last)
    note(document_.children(*transform)[3].node,
         "a fourth row is 0, 0, 0, 1: a transform is affine");
  glm::dmat3 linear;
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      linear[column][row] = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      largest = std::max(largest, std::abs(linear[column][row]));
    }
  if (!(largest > 0) || glm::determinant(linear / largest) == 0)
    note(*transform, "the transform flattens the mesh; its first three columns are independent");
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
    note(*target, "nearer to position than 1e-150, the least length that can be computed with");
  else if (has_dimension(3))
    check_up(*camera, {apart(0), apart(1), apart(2)});
}

void Check::check_up(JsonNode camera, const Coordinates& view) {
  const auto up = document_.find(camera, "up");
  if (up && is_faulty(*up)) return;
  const Coordinates y{0, 1, 0};
  const Coordinates direction = up ? (*up)->get<Coordinates>() : y;
  if (too_near(direction, {}))
    note(*up, "up has no length; it is the direction that is up in the picture");
  else if (is_narrow(direction, view))
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
