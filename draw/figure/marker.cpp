#include "draw/figure/marker.h"

#include <array>

namespace wander::figure {
namespace {

struct Shape {
  std::string_view data;  // after a move to the middle; relative
  bool filled;
};

// Circle, square, triangle, diamond, cross, triangle downwards, plus, hollow circle.
constexpr std::array<Shape, 8> shapes{
    {{"m-2.3 0a2.3 2.3 0 1 0 4.6 0a2.3 2.3 0 1 0 -4.6 0Z", true},
     {"m-2.1 -2.1h4.2v4.2h-4.2Z", true},
     {"m0 -2.8l2.6 4.6h-5.2Z", true},
     {"m0 -3l3 3l-3 3l-3 -3Z", true},
     {"m-2.2 -2.2l4.4 4.4m0 -4.4l-4.4 4.4", false},
     {"m0 2.8l2.6 -4.6h-5.2Z", true},
     {"m-2.8 0h5.6m-2.8 -2.8v5.6", false},
     {"m-2.3 0a2.3 2.3 0 1 0 4.6 0a2.3 2.3 0 1 0 -4.6 0Z", false}}};

}  // namespace

Look look_of(std::size_t k) { return {style::films[k % style::films.size()], k % shapes.size()}; }

void draw_marker(Svg& svg, Vector at, const Look& look) {
  const Shape& shape = shapes[look.marker % shapes.size()];
  svg.path("M" + coordinates(at) + std::string(shape.data),
           {{"class", "marker"},
            {"fill", shape.filled ? look.stroke.colour : "none"},
            {"stroke", look.stroke.colour},
            {"stroke-width", shape.filled ? 0.4 : 1.1}});
}

void draw_open_marker(Svg& svg, Vector at, const Look& look) {
  svg.path("M" + coordinates(at) + std::string(shapes[look.marker % shapes.size()].data),
           {{"class", "open marker"},
            {"fill", style::paper},
            {"stroke", look.stroke.colour},
            {"stroke-width", 1.1}});
}

}  // namespace wander::figure
