// A small part of a scene, enlarged: where a step moved its path too little to be seen.
#pragma once

#include <optional>

#include "core/description.h"
#include "draw/figure/path_frame.h"

namespace wander::figure {

// A square of the scene.
struct Zoom {
  Vector middle;
  double half;  // of its side, in metres
};

// Where the path moved most; none where the whole scene, at so many points to the metre, shows it.
std::optional<Zoom> zoom_of(const PathFrame& frame, double scale);

// The square in the drawing of the whole scene.
void draw_zoom_frame(Svg& svg, const Zoom& zoom, const PageMap& map);
// The enlarged square, with the curves of the scene, the paths, and how many times as large.
void draw_zoom(Svg& svg, const PathFrame& frame, const description::Scene& scene, const Zoom& zoom,
               const PageMap& whole, Vector top_left, double side);

}  // namespace wander::figure
