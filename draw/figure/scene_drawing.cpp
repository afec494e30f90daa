#include "draw/figure/scene_drawing.h"

#include <algorithm>
#include <glm/common.hpp>
#include <optional>
#include <vector>

#include "draw/figure/axis.h"
#include "draw/figure/region.h"

namespace wander::figure {
namespace {

// The camera's triangle, in the diagonal of what it looks at.
constexpr double camera_size = 0.09;
// Of the hatched ribbon inside an open dielectric, in points.
constexpr double ribbon_width = 4.5;

Extent extent_of_shapes(const description::Scene& scene) {
  Extent extent;
  for (const description::Shape& shape : scene.shapes)
    for (const Curve& curve : curves(shape.kind)) extent.include(curve);
  return extent;
}

// A scene that is a single line, or a point, still needs room to be drawn in.
Extent with_an_inside(const Extent& extent) {
  const double largest = std::max(extent.size().x, extent.size().y);
  const Vector least = largest > 0 ? Vector(0.2 * largest) : Vector(1);
  const Vector missing = glm::max(least - extent.size(), Vector(0)) / 2.;
  return {extent.low - missing, extent.high + missing};
}

std::optional<Wedge> wedge_of(const description::Scene& scene) {
  if (!scene.camera) return std::nullopt;
  Extent extent = extent_of_shapes(scene);
  extent.include({scene.camera->position[0], scene.camera->position[1]});
  return camera_wedge(*scene.camera, camera_size * glm::length(extent.size()));
}

void draw_insides(Svg& svg, const description::Scene& scene, Surface surface, const PageMap& map) {
  std::vector<description::ShapeKind> outlines;
  for (const description::Shape& shape : scene.shapes)
    if (surface_of(scene, shape) == surface) outlines.push_back(shape.kind);
  const Insides insides = find_insides(outlines, map, glm::length(extent_of(scene).size()));
  for (const std::string& region : insides.regions) draw_inside(svg, surface, region);
  for (const Curve& curve : insides.open)
    draw_inside_ribbon(svg, surface, outline(curve, map, -ribbon_width / 2), ribbon_width);
}

void draw_roles(Svg& svg, const description::Scene& scene, const description::Shape& shape,
                const PageMap& map) {
  const std::vector<Curve> parts = curves(shape.kind);
  const Offset light = surface_of(scene, shape) ? Offset::above_surface : Offset::none;
  const Offset sensor = shape.light ? Offset::above_light : light;
  if (shape.light) draw_role(svg, Role::light, parts, map, light);
  if (shape.sensor) draw_role(svg, Role::sensor, parts, map, sensor);
}

void draw_marks(Svg& svg, const description::Scene& scene, const PageMap& map) {
  for (const description::Shape& shape : scene.shapes)
    if (const auto surface = surface_of(scene, shape))
      draw_surface(svg, *surface, outline(shape.kind, map));
  for (const description::Shape& shape : scene.shapes) draw_roles(svg, scene, shape, map);
  if (const auto wedge = wedge_of(scene)) draw_camera(svg, *wedge, map);
}

}  // namespace

Extent extent_of(const description::Scene& scene) {
  Extent extent = extent_of_shapes(scene);
  if (const auto wedge = wedge_of(scene))
    for (const Vector corner : {wedge->apex, wedge->first, wedge->last}) extent.include(corner);
  extent = with_an_inside(extent);
  // What the axes will show, where doubles cannot resolve the scene this far from the origin.
  const Range x = usable({extent.low.x, extent.high.x}), y = usable({extent.low.y, extent.high.y});
  return with_an_inside({{x.low, y.low}, {x.high, y.high}});
}

PageMap fit(const Extent& extent, Vector page_low, Vector page_high) {
  const Vector room = page_high - page_low, size = extent.size();
  const double scale = std::min(room.x / size.x, room.y / size.y);
  const Vector middle = (page_low + page_high) / 2.;
  return {extent.low, {middle.x - size.x * scale / 2, middle.y + size.y * scale / 2}, scale};
}

void draw_scene(Svg& svg, const description::Scene& scene, const PageMap& map) {
  define_patterns(svg);
  const auto scope = svg.group("scene");
  for (const Surface surface : {Surface::dielectric, Surface::rough_dielectric})
    draw_insides(svg, scene, surface, map);
  draw_marks(svg, scene, map);
}

void draw_outlines(Svg& svg, const description::Scene& scene, const PageMap& map) {
  const auto scope = svg.group("scene");
  draw_marks(svg, scene, map);
}

}  // namespace wander::figure
