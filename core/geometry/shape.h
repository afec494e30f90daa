// The list of shapes: those that scene files name, and the curves and surfaces of each world that
// rays meet.  Each is defined in its own file.
#pragma once

#include <utility>
#include <variant>

#include "core/geometry/mesh.h"
#include "core/geometry/shapes_flat.h"
#include "core/geometry/shapes_space.h"
#include "core/geometry/triangle.h"

namespace wander {

namespace description {
using ShapeKind =
    std::variant<Segment, Polyline, Circle, Arc, Triangle, Parallelogram, Sphere, Mesh>;
}

template <World W, int D>
struct ShapesOf;
template <World W>
struct ShapesOf<W, 2> {
  using Variant = std::variant<Segment<W>, Arc<W>>;
};
template <World W>
struct ShapesOf<W, 3> {
  using Variant = std::variant<Parallelogram<W>, Triangle<W>, Mesh<W>, Sphere<W>>;
};

template <World W>
using Shape = typename ShapesOf<W, W::dimension>::Variant;

// Alternative i and those after it, one after the other: none of them is looked up in a table.
template <std::size_t i, class Visitor, class... Shapes>
decltype(auto) visit_shape_from(Visitor&& visitor, const std::variant<Shapes...>& shape) {
  const auto* found = std::get_if<i>(&shape);
  if constexpr (i + 1 < sizeof...(Shapes))
    if (found == nullptr) return visit_shape_from<i + 1>(std::forward<Visitor>(visitor), shape);
  return visitor(*found);
}

// The first alternative is by far the commonest: it is tested first.
template <class Visitor, class First, class... Rest>
decltype(auto) visit_shape(Visitor&& visitor, const std::variant<First, Rest...>& shape) {
  if (const First* first = std::get_if<First>(&shape)) [[likely]]
    return visitor(*first);
  return visit_shape_from<1>(std::forward<Visitor>(visitor), shape);
}

template <World W>
std::int32_t primitives(const Shape<W>& shape) {
  return visit_shape(
      [](const auto& s) -> std::int32_t {
        if constexpr (requires { s.primitives(); })
          return s.primitives();
        else
          return 1;
      },
      shape);
}
template <World W>
Box<W> bounds(const Shape<W>& shape, std::int32_t primitive) {
  return visit_shape(
      [primitive](const auto& s) -> Box<W> {
        if constexpr (requires { s.primitives(); })
          return s.bounds(primitive);
        else
          return s.bounds();
      },
      shape);
}

}  // namespace wander
