// What recorded paths are drawn over: a scene of the plane, or the picture that the camera of a
// scene in space has of it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/description.h"
#include "draw/figure/curve.h"
#include "draw/figure/steps.h"
#include "draw/figure/wireframe.h"

namespace wander::figure {

struct Stage {
  Extent extent;
  std::function<void(Svg& svg, const PageMap& map)> draw;
  Projection projection{};                    // into it; empty: paths lie in it as they are
  const description::Scene* plane = nullptr;  // parts of which can be drawn enlarged
};

// The scene outlives it.
Stage plane_stage(const description::Scene& scene);
// The outline, over a picture of the same view (PNG) if there is one.
Stage space_stage(const View& view, std::vector<WireLine> outline, std::string picture = {});

}  // namespace wander::figure
