#include "records/scene_curves.h"

#include <limits>

namespace wander {

namespace {

using namespace description;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void add_point(std::vector<double>& column, double x, double y) {
  column.push_back(x);
  column.push_back(y);
}

// Adds the curves of one shape.
struct CurveAdder {
  SceneCurves& curves;

  void operator()(const Segment& s) { add_segment(s.from, s.to); }
  void operator()(const Polyline& s) {
    for (std::size_t i = 0; i + 1 < s.points.size(); ++i) add_segment(s.points[i], s.points[i + 1]);
    if (s.closed) add_segment(s.points.back(), s.points.front());
  }
  void operator()(const Circle& s) { add_arc({s.center, s.radius, 0, 360, s.flip}); }
  void operator()(const Arc& s) { add_arc(s); }

  void add_segment(const Coordinates& from, const Coordinates& to) {
    curves.kind.push_back(0);
    add_point(curves.from, from[0], from[1]);
    add_point(curves.to, to[0], to[1]);
    add_point(curves.center, none, none);
    for (auto* column : {&curves.radius, &curves.from_degrees, &curves.to_degrees})
      column->push_back(none);
    curves.flipped.push_back(0);
  }
  void add_arc(const Arc& arc) {
    curves.kind.push_back(1);
    add_point(curves.from, none, none);
    add_point(curves.to, none, none);
    add_point(curves.center, arc.center[0], arc.center[1]);
    curves.radius.push_back(arc.radius);
    curves.from_degrees.push_back(arc.from_degrees);
    curves.to_degrees.push_back(arc.to_degrees);
    curves.flipped.push_back(arc.flip ? 1 : 0);
  }
};

}  // namespace

SceneCurves scene_curves(const Scene& scene) {
  SceneCurves curves;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const Shape& shape = scene.shapes[i];
    visit_known(CurveAdder{curves}, shape.kind);
    // The kinds of materials are numbered as description.h lists them.
    const std::size_t material =
        shape.material ? scene.materials.at(*shape.material).kind.index() : 0;
    const std::size_t count = curves.kind.size();
    curves.shape.resize(count, static_cast<std::int32_t>(i));
    curves.material.resize(count, static_cast<std::int32_t>(material));
    curves.radiance.resize(count, shape.light ? shape.light->radiance.channels[0] : 0);
    curves.is_sensor.resize(count, shape.sensor ? 1 : 0);
  }
  return curves;
}

}  // namespace wander
