#include "scenes/import/sensor.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

#include "scenes/format/json_text.h"
#include "scenes/import/number_words.h"
#include "scenes/import/placing.h"
#include "scenes/import/plugin.h"

namespace wander {

namespace {

using nlohmann::ordered_json;
using placing::Vector;

constexpr double degree = std::numbers::pi / 180;

class SensorReader {
 public:
  SensorReader(const XmlElement& element, const ImportContext& context)
      : sensor_(element, context), context_(context) {}

  ImportedSensor read() {
    const bool has_lens = sensor_.type() == "thinlens";
    if (!has_lens && sensor_.type() != "perspective") {
      fault(sensor_.element(),
            fmt::format("the sensor \"{}\" is not known; known are perspective and "
                        "thinlens",
                        excerpt(sensor_.type())));
      return {};
    }
    ImportedSensor result;
    result.camera = {{"type", "perspective"}};
    read_film();
    place(result);
    result.camera["fov_deg"] = horizontal_degrees();
    result.camera["resolution"] = resolution_;
    const double far = sensor_.number("far_clip", 1e4);
    if (has_lens) read_lens(result.camera, far);
    sensor_.ignore({"near_clip", "shutter_open", "shutter_close", "srf", "focus_distance"});
    for (const char* name : {"principal_point_offset_x", "principal_point_offset_y"})
      if (sensor_.number(name, 0) != 0)
        inexact(sensor_.where(name), "a picture that is shifted", "one around the axis");
    for (const XmlElement* medium : sensor_.objects("medium"))
      inexact(*medium, "a medium", "nothing");
    sensor_.objects("sampler");
    sensor_.done();
    return result;
  }

 private:
  void fault(const XmlElement& element, std::string_view what) {
    context_.diagnosis.fault(element, what);
  }
  void inexact(const XmlElement& element, std::string_view what, std::string_view instead) {
    context_.diagnosis.inexact(element, what, instead);
  }

  // x points to the left of the picture, y up, z ahead.
  void place(ImportedSensor& result) {
    const glm::dmat4 matrix = sensor_.transform("to_world");
    const glm::dmat3 linear(matrix);
    const XmlElement& where = sensor_.where("to_world");
    constexpr double slack = 1e-3;  // that of Mitsuba
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        if (std::abs(glm::dot(linear[i], linear[j]) - (i == j ? 1 : 0)) > slack)
          return fault(where, "a sensor is turned and shifted, not scaled or sheared");
    if (glm::determinant(linear) < 0)
      inexact(where, "a picture that its transform mirrors", "one that is not mirrored");
    result.position = Vector(matrix[3]);
    result.camera["position"] = placing::json_of(result.position);
    result.camera["target"] = placing::json_of(result.position + glm::normalize(linear[2]));
    result.camera["up"] = placing::json_of(glm::normalize(linear[1]));
  }

  void read_film() {
    const auto films = sensor_.objects("film");
    if (films.size() > 1) fault(*films[1], "a sensor has one film; this is another");
    if (films.empty()) return;
    Plugin film(*films.front(), context_);
    const std::array sides{"width", "height"};
    for (std::size_t i = 0; i < 2; ++i) {
      resolution_[i] = film.integer(sides[i], resolution_[i]);
      if (resolution_[i] < 1)
        fault(film.where(sides[i]), fmt::format("a {} is an integer > 0", sides[i]));
    }
    read_crop(film);
    read_filter(film);
    film.ignore({"file_format", "pixel_format", "component_format", "banner", "gamma", "exposure",
                 "tonemap_method", "high_quality_edges", "attach_log", "label", "channel_names",
                 "sample_border", "compensate", "key", "burn", "fill", "digits", "variable",
                 "filename"});
    film.done();
  }

  void read_crop(Plugin& film) {
    const std::array<std::pair<const char*, int>, 4> whole{{{"crop_width", resolution_[0]},
                                                            {"crop_height", resolution_[1]},
                                                            {"crop_offset_x", 0},
                                                            {"crop_offset_y", 0}}};
    const char* part = nullptr;
    for (const auto& [name, usual] : whole)  // all are read, or the rest would not be known
      if (film.integer(name, usual) != usual && part == nullptr) part = name;
    if (part != nullptr) inexact(film.where(part), "a part of a film", "all of it");
  }

  void read_filter(Plugin& film) {
    const auto filters = film.objects("rfilter");
    if (filters.empty())
      context_.diagnosis.note(film.element(),
                              "without an rfilter Mitsuba's is a gaussian; here pixels are boxes");
    else if (filters.front()->type() != "box")
      inexact(*filters.front(),
              fmt::format("the pixel filter \"{}\"", excerpt(filters.front()->type())), "a box");
  }

  double horizontal_degrees() {
    const double aspect = static_cast<double>(resolution_[0]) / resolution_[1];
    std::string axis = sensor_.text("fov_axis", "x");
    double tangent = 0;  // of half the angle, along the axis
    if (sensor_.has("fov")) {
      const double degrees = sensor_.number("fov", 45);
      if (!(degrees > 0 && degrees < 180))
        fault(sensor_.where("fov"), "a field of view is > 0 and < 180 degrees");
      tangent = std::tan(degrees / 2 * degree);
      sensor_.ignore({"focal_length"});
    } else {  // of the diagonal of 36 by 24 mm
      std::string length = sensor_.text("focal_length", "50mm");
      if (length.ends_with("mm")) length.resize(length.size() - 2);
      const auto millimetres = number_in(length);
      if (!millimetres || !(*millimetres > 0))
        fault(sensor_.where("focal_length"), "a focal length is a number > 0 of mm");
      tangent = std::hypot(36, 24) / 2 / millimetres.value_or(50);
      axis = "diagonal";
    }
    if (axis == "smaller") axis = aspect > 1 ? "y" : "x";
    if (axis == "larger") axis = aspect > 1 ? "x" : "y";
    if (axis == "y")
      tangent *= aspect;
    else if (axis == "diagonal")
      tangent /= std::hypot(1, 1 / aspect);
    else if (axis == "x" && sensor_.has("fov"))
      return sensor_.number("fov", 45);  // to the last bit
    else if (axis != "x")
      fault(sensor_.where("fov_axis"), "fov_axis is x, y, diagonal, smaller or larger");
    return 2 * std::atan(tangent) / degree;
  }

  void read_lens(ordered_json& camera, double far) {
    const double radius = sensor_.number("aperture_radius", 0);
    const double distance = sensor_.number("focus_distance", far);
    if (!sensor_.has("aperture_radius"))
      fault(sensor_.element(), "a thinlens has an aperture_radius");
    if (radius < 0) fault(sensor_.where("aperture_radius"), "an aperture_radius is not below 0");
    if (!(distance > 0)) fault(sensor_.where("focus_distance"), "a focus_distance is > 0");
    camera["aperture_radius"] = radius;
    camera["focus_distance"] = distance;
  }

  Plugin sensor_;
  const ImportContext& context_;
  std::array<int, 2> resolution_{768, 576};
};

}  // namespace

ImportedSensor import_sensor(const XmlElement& sensor, const ImportContext& context) {
  return SensorReader(sensor, context).read();
}

}  // namespace wander
