// The marks of a scene drawing, each legible without colour:
//
//   diffuse          a thick line            rough ...    the same with a fine comb across
//   mirror           a double line           light        red, with rays on the emitting side
//   dielectric       a thin line, hatched    sensor       blue, with pins on the listening side and
//                    on the inside                        a dot where the film begins
//   black            a dotted line           camera       its field of view and its film
//
// The drawing and its legend use the same functions, so they cannot disagree.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/description.h"
#include "draw/figure/curve.h"
#include "draw/figure/svg.h"

namespace wander::figure {

enum class Surface { black, diffuse, mirror, dielectric, rough_conductor, rough_dielectric };
enum class Role { light, sensor };

// What the shape is made of; nothing for a light or a sensor that hangs free.
std::optional<Surface> surface_of(const description::Scene& scene, const description::Shape& shape);
bool is_transparent(Surface surface);

// Fill patterns for the insides of dielectrics, before the first surface.
void define_patterns(Svg& svg);

void draw_surface(Svg& svg, Surface surface, std::string_view path_data);
// The inside of a transparent surface: a region, or a ribbon along a path with this width.
void draw_inside(Svg& svg, Surface surface, std::string_view path_data);
void draw_inside_ribbon(Svg& svg, Surface surface, std::string_view path_data, double width);

// How far, in points, the line of a light or sensor keeps from the curve it lies on.
enum class Offset { none, above_surface, above_light };

// The line of a light or sensor, and its rays or pins on the side of the normal.
void draw_role(Svg& svg, Role role, std::span<const Curve> curves, const PageMap& map,
               Offset offset);

// The triangle of a camera in the scene: its position and the ends of its film, bin 0 first.
struct Wedge {
  Vector apex, first, last;
};
Wedge camera_wedge(const description::Camera& camera, double size);
void draw_camera(Svg& svg, const Wedge& wedge, const PageMap& map);

}  // namespace wander::figure
