#include "records/scene_curves.h"

#include <algorithm>
#include <limits>

#include "core/requirements.h"

namespace wander {

namespace {

using description::Coordinates;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void add_point(std::vector<double>& column, const Coordinates& point) {
  column.push_back(point[0]);
  column.push_back(point[1]);
}

// Adds the curves of one shape.
struct CurveAdder {
  SceneCurves& curves;

  void operator()(const description::Segment& s) {
    curves.kind.push_back(0);
    add_point(curves.from, s.from);
    add_point(curves.to, s.to);
    add_point(curves.center, {none, none});
    for (auto* column : {&curves.radius, &curves.from_degrees, &curves.to_degrees})
      column->push_back(none);
    curves.flipped.push_back(0);
  }
  void operator()(const description::Arc& arc) {
    curves.kind.push_back(1);
    add_point(curves.from, {none, none});
    add_point(curves.to, {none, none});
    add_point(curves.center, arc.center);
    curves.radius.push_back(arc.radius);
    curves.from_degrees.push_back(arc.from_degrees);
    curves.to_degrees.push_back(arc.to_degrees);
    curves.flipped.push_back(arc.flip ? 1 : 0);
  }
};

}  // namespace

std::int32_t material_number(const description::Scene& scene, const description::Shape& shape) {
  const std::string type =
      shape.material ? type_of(scene.materials.at(*shape.material).kind) : "black";
  return static_cast<std::int32_t>(std::ranges::find(material_types, type) -
                                   material_types.begin());
}

SceneCurves scene_curves(const description::Scene& scene) {
  SceneCurves curves;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const description::Shape& shape = scene.shapes[i];
    for (const auto& stroke : outline_of(shape.kind)) std::visit(CurveAdder{curves}, stroke);
    const std::size_t count = curves.kind.size();
    curves.shape.resize(count, static_cast<std::int32_t>(i));
    curves.material.resize(count, material_number(scene, shape));
    curves.radiance.resize(count, shape.light ? luminance(shape.light->radiance) : 0);
    curves.is_sensor.resize(count, shape.sensor ? 1 : 0);
  }
  return curves;
}

}  // namespace wander
