// A binary hierarchy of bounding boxes over the primitives of a scene's shapes, in the precision of
// their lengths and in any dimension.  Few primitives make a single leaf, so a small scene pays for
// no hierarchy.
#pragma once

#include <span>

#include "core/geometry/box_tree.h"

namespace wander {

// What a leaf holds of a primitive: in the plane a copy, for a shape is small there; in space its
// name.
template <World W, int D = W::dimension>
struct BvhItem {
  Shape<W> shape;
  Element<W> element;

  BvhItem(std::span<const Shape<W>> shapes, Element<W> named)
      : shape(shapes[static_cast<std::size_t>(named.shape)]), element(named) {}
  const Shape<W>& shape_in(std::span<const Shape<W>>) const { return shape; }
};
template <World W>
struct BvhItem<W, 3> {
  Element<W> element;

  BvhItem(std::span<const Shape<W>>, Element<W> named) : element(named) {}
  const Shape<W>& shape_in(std::span<const Shape<W>> shapes) const {
    return shapes[static_cast<std::size_t>(element.shape)];
  }
};

template <World W>
class Bvh {
 public:
  using Universe = W;
  using Length = typename W::Length;

  Bvh() = default;
  explicit Bvh(std::span<const Shape<W>> shapes);  // which outlive it

  Hit<W> closest(const Ray<W>& ray) const;
  bool any(const Ray<W>& ray) const;

 private:
  using Node = typename BoxTree<W>::Node;

  Length distance(const BvhItem<W>& item, const ReadyRay<W>& ray) const {
    return visit_shape([&](const auto& shape) { return shape.intersect(ray, item.element); },
                       item.shape_in(shapes_));
  }

  // Visits the leaves that the ray may enter, nearest child first; the visitor returns the distance
  // beyond which nothing matters any more.
  template <class Leaf>
  void traverse(const Ray<W>& ray, Leaf&& leaf) const;

  std::span<const Shape<W>> shapes_;
  std::vector<Node> nodes_;
  std::vector<BvhItem<W>> items_;
};

}  // namespace wander
