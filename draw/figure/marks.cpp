#include "draw/figure/marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/figure/meanings.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double wall_width = 1.9;
constexpr double mark_length = 5.5, mark_spacing = 6.5;
// Anything shorter on the page gets a ring, or it would be overlooked.
constexpr double visible_length = 3;

struct SurfaceOf {
  Surface operator()(const description::Black&) const { return Surface::black; }
  Surface operator()(const description::Diffuse&) const { return Surface::diffuse; }
  Surface operator()(const description::Mirror&) const { return Surface::mirror; }
  Surface operator()(const description::Dielectric&) const { return Surface::dielectric; }
  Surface operator()(const description::RoughConductor&) const { return Surface::rough_conductor; }
  Surface operator()(const description::RoughDielectric&) const {
    return Surface::rough_dielectric;
  }
  Surface operator()(const description::Conductor&) const { return Surface::mirror; }
  Surface operator()(const description::RoughMetal&) const { return Surface::rough_conductor; }
};

void stroke(Svg& svg, std::string_view data, std::string_view colour, double width) {
  svg.path(data, {{"stroke", colour}, {"stroke-width", width}, {"fill", "none"}});
}

void dashed(Svg& svg, std::string_view data, std::string_view colour, double width,
            std::string_view dashes) {
  svg.path(data, {{"stroke", colour},
                  {"stroke-width", width},
                  {"stroke-dasharray", dashes},
                  {"stroke-linejoin", "bevel"},  // a mitred tooth at a corner would be a thorn
                  {"fill", "none"}});
}

void double_line(Svg& svg, std::string_view data) {
  stroke(svg, data, style::wall, 2.6);
  stroke(svg, data, style::paper, 1.3);
}

// Teeth across the line: roughness.
void comb(Svg& svg, std::string_view data) { dashed(svg, data, style::wall, 4.6, "0.55 1.45"); }

const Fill& inside_fill(Surface surface) {
  return surface == Surface::rough_dielectric ? rough_glass : clear_glass;
}

std::string_view colour(Role role) { return role == Role::light ? style::light : style::sensor; }

void dot(Svg& svg, Vector at, double radius, std::string_view fill) {
  svg.element("circle", {{"cx", at.x}, {"cy", at.y}, {"r", radius}, {"fill", fill}});
}

void ring(Svg& svg, Vector at, double radius, std::string_view colour) {
  svg.element("circle", {{"cx", at.x},
                         {"cy", at.y},
                         {"r", radius},
                         {"fill", "none"},
                         {"stroke", colour},
                         {"stroke-width", 0.7}});
}

double distance_of(Offset offset) {
  switch (offset) {
    case Offset::none:
      return 0;
    case Offset::above_surface:
      return 1.9;
    case Offset::above_light:
      return 3.7;
  }
  return 0;
}

// Rays and pins stand evenly along the curve, on the side of its normal; pins above a light stand
// between its rays.
void draw_marks(Svg& svg, Role role, const Curve& curve, const PageMap& map, Offset offset) {
  const double page_length = length(curve) * map.scale;
  const int count = std::clamp(static_cast<int>(page_length / mark_spacing), 1, 400);
  const double shift = offset == Offset::above_light ? 0.9 : 0.5;
  for (int k = 0; k < count; ++k) {
    const Spot foot = spot(curve, (k + shift) / count);
    const Vector base = map(foot.position);
    const Vector tip = base + (mark_length + distance_of(offset)) * map.direction(foot.normal);
    svg.line(base, tip, {{"stroke", colour(role)}, {"stroke-width", 0.7}});
    if (role == Role::sensor) dot(svg, tip, 0.95, colour(role));
  }
}

}  // namespace

std::optional<Surface> surface_of(const description::Scene& scene,
                                  const description::Shape& shape) {
  if (shape.material) return std::visit(SurfaceOf{}, scene.materials[*shape.material].kind);
  if (shape.light || shape.sensor) return std::nullopt;
  return Surface::black;
}

bool is_transparent(Surface surface) {
  return surface == Surface::dielectric || surface == Surface::rough_dielectric;
}

void define_patterns(Svg& svg) {
  define_fill(svg, clear_glass);
  define_fill(svg, rough_glass);
}

void draw_surface(Svg& svg, Surface surface, std::string_view data) {
  switch (surface) {
    case Surface::black:
      svg.path(data, {{"stroke", style::ink},
                      {"stroke-width", 2},
                      {"stroke-linecap", "round"},
                      {"stroke-dasharray", "0.01 3"},
                      {"fill", "none"}});
      return;
    case Surface::diffuse:
      stroke(svg, data, style::wall, wall_width);
      return;
    case Surface::mirror:
      double_line(svg, data);
      return;
    case Surface::dielectric:
      stroke(svg, data, style::wall, 0.8);
      return;
    case Surface::rough_conductor:
      comb(svg, data);
      double_line(svg, data);
      return;
    case Surface::rough_dielectric:
      dashed(svg, data, style::wall, 3, "0.55 1.45");
      stroke(svg, data, style::wall, 0.8);
      return;
  }
}

void draw_inside(Svg& svg, Surface surface, std::string_view data) {
  svg.path(data, {{"fill", define_fill(svg, inside_fill(surface))}});
}

void draw_inside_ribbon(Svg& svg, Surface surface, std::string_view data, double width) {
  stroke(svg, data, define_fill(svg, inside_fill(surface)), width);
}

void draw_role(Svg& svg, Role role, std::span<const Curve> curves, const PageMap& map,
               Offset offset) {
  const double distance = distance_of(offset);
  const auto scope = svg.group(role == Role::light ? "light" : "sensor");
  for (const Curve& curve : curves) {
    draw_marks(svg, role, curve, map, offset);
    stroke(svg, outline(curve, map, distance), colour(role), 1.9);
    if (length(curve) * map.scale < visible_length)
      ring(svg, map(spot(curve, 0.5).position), 3.5, colour(role));
  }
  if (role == Role::sensor && !curves.empty()) {
    const Spot start = spot(curves.front(), 0);
    dot(svg, map(start.position) + distance * map.direction(start.normal), 1.8, colour(role));
  }
}

Wedge camera_wedge(const description::Camera& camera, double size) {
  const Vector position{camera.position[0], camera.position[1]};
  const Vector towards = Vector{camera.target[0], camera.target[1]} - position;
  const double axis = std::atan2(towards.y, towards.x);
  const double half = camera.fov_degrees / 2 * std::numbers::pi / 180;
  const auto corner = [&](double angle) {
    return position + size * Vector{std::cos(angle), std::sin(angle)};
  };
  return {position, corner(axis + half), corner(axis - half)};
}

void draw_camera(Svg& svg, const Wedge& wedge, const PageMap& map) {
  const auto scope = svg.group("camera");
  const Vector apex = map(wedge.apex), first = map(wedge.first), last = map(wedge.last);
  svg.path("M" + coordinates(first) + "L" + coordinates(apex) + "L" + coordinates(last),
           {{"stroke", style::sensor},
            {"stroke-width", 0.8},
            {"fill", style::sensor},
            {"fill-opacity", 0.12},
            {"stroke-linejoin", "round"}});
  stroke(svg, "M" + coordinates(first) + "L" + coordinates(last), style::sensor, 1.9);
  dot(svg, apex, 1.6, style::sensor);
  dot(svg, first, 1.8, style::sensor);
}

}  // namespace wander::figure
