// The hierarchy that rays in space run through: each node has several children, whose boxes a ray
// meets in one sweep of its lanes.  Bvh is its reference in tests: both find the same.
//
// Boxes are held in single precision, in coordinates in which the scene is of the order of one
// (centred, and multiplied by a power of two, so that the scale of a scene changes nothing).  They
// and the origin of a ray are rounded outwards, and the exit is widened by what rounding does to a
// slab test [Ize 2013]: a box may be entered in vain, and none is missed.  What decides is the
// intersection with a primitive, in the precision of lengths.
#pragma once

#include "core/geometry/box_tree.h"

namespace wander {

template <World W>
class WideBvh {
 public:
  using Universe = W;
  using Length = typename W::Length;
  using Point = typename W::Point;

  WideBvh() = default;
  explicit WideBvh(std::span<const Shape<W>> shapes);  // which outlive it

  Hit<W> closest(const Ray<W>& ray) const;
  bool any(const Ray<W>& ray) const;

 private:
  static constexpr int width = 4;
  using Lanes [[gnu::vector_size(width * sizeof(float))]] = float;

  // Without initial values: a traversal has many on its stack, and touches few.
  struct Child {
    std::int32_t first;  // of its elements in a leaf, otherwise the node
    std::int32_t count;  // of its elements; 0 where it is a node
  };
  enum Side { low, high };
  struct Node {
    std::array<std::array<Lanes, 2>, W::dimension> planes;  // [axis][side]
    std::array<Child, width> children;                      // of empty boxes at the end
  };
  struct Slabs;
  struct Builder;

  Length distance(Element<W> element, const ReadyRay<W>& ray) const {
    return visit_shape([&](const auto& shape) { return shape.intersect(ray, element); },
                       shapes_[static_cast<std::size_t>(element.shape)]);
  }
  // Visits the leaves that the ray may enter, the nearest child of a node first; the visitor returns
  // the distance beyond which nothing matters any more.
  template <class Leaf>
  void traverse(const Ray<W>& ray, Leaf&& leaf) const;

  std::span<const Shape<W>> shapes_;
  std::vector<Node> nodes_;  // none where the scene is one leaf
  std::vector<Element<W>> elements_;
  Point center_{};
  Length scale_ = 1;  // into the coordinates of the boxes: (p - center) scale
};

}  // namespace wander
