// A scene drawn into a rectangle of a page.  Whole figures with axes, legends and captions are made
// of this: scene_figure.h, film_figure.h.
#pragma once

#include "core/description.h"
#include "draw/figure/marks.h"

namespace wander::figure {

// Everything of a two-dimensional scene, its camera included; never empty.
Extent extent_of(const description::Scene& scene);

// The largest equal-aspect map of an extent into a rectangle on the page, centred.
PageMap fit(const Extent& extent, Vector page_low, Vector page_high);

void draw_scene(Svg& svg, const description::Scene& scene, const PageMap& map);
// Without the insides of glass, over a picture that is to be seen there.
void draw_outlines(Svg& svg, const description::Scene& scene, const PageMap& map);

}  // namespace wander::figure
