// A hierarchy of bounding boxes over the shapes of a scene, in any dimension.
//
// Built once by the surface-area heuristic (in the plane: perimeter), deterministic, and invariant
// when a scene is multiplied by a power of two.  Few shapes make a single leaf, so a small scene
// pays for no hierarchy.
#pragma once

#include <span>

#include "core/geometry/shape.h"

namespace wander {

template <World W>
class Bvh {
 public:
  using Length = typename W::Length;

  Bvh() = default;
  explicit Bvh(std::span<const Shape<W>> shapes);

  Hit<W> closest(const Ray<W>& ray) const;
  bool any(const Ray<W>& ray) const;

 private:
  struct Node {
    Box<W> box;
    std::int32_t first = 0;  // of its shapes in a leaf, of its two children otherwise
    std::int32_t count = 0;  // of its shapes; 0 in an inner node
  };
  struct Item {
    Shape<W> shape;
    ShapeId id;
  };
  struct Builder;

  // Visits the leaves that the ray may enter, nearest child first; the visitor returns the distance
  // beyond which nothing matters any more.
  template <class Leaf>
  void traverse(const Ray<W>& ray, Leaf&& leaf) const;

  std::vector<Node> nodes_;
  std::vector<Item> items_;
};

}  // namespace wander
