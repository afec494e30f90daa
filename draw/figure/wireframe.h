// The outline of a scene in space: the edges of its faces, of meshes those where they bend or turn
// away from the eye, and the rims of spheres.  What is hidden is drawn as well.
#pragma once

#include <vector>

#include "draw/figure/view.h"

namespace wander::figure {

enum class WireKind { surface, glass, light, sensor };

struct WireLine {
  Place from, to;
  WireKind kind;
};

// The lights and sensors last, for they are drawn over the rest.  Of very many, some.
std::vector<WireLine> wireframe(const SceneFaces& faces, const Place& eye);

void draw_wireframe(Svg& svg, const std::vector<WireLine>& lines, const View& view,
                    const PageMap& map);
void draw_wire(Svg& svg, WireKind kind, std::string_view data);

}  // namespace wander::figure
