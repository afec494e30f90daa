// The closed set of shapes of each world.
#pragma once

#include <variant>

#include "core/geometry/shapes_flat.h"
#include "core/geometry/shapes_space.h"

namespace wander {

template <World W, int D>
struct ShapesOf;
template <World W>
struct ShapesOf<W, 2> {
  using Variant = std::variant<Segment<W>, Arc<W>>;
};
template <World W>
struct ShapesOf<W, 3> {
  using Variant = std::variant<Parallelogram<W>, Sphere<W>>;
};

template <World W>
using Shape = typename ShapesOf<W, W::dimension>::Variant;

// Index of the flat alternative.
inline constexpr std::size_t flat_shape = 0;

// The first alternative, the flat one, is by far the commonest: it is tested first.
template <class Visitor, class First, class Second>
decltype(auto) visit_shape(Visitor&& visitor, const std::variant<First, Second>& shape) {
  if (const First* first = std::get_if<First>(&shape)) [[likely]]
    return visitor(*first);
  return visitor(*std::get_if<Second>(&shape));
}

}  // namespace wander
