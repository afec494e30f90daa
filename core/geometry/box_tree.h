// A binary tree of bounding boxes over the primitives of a scene's shapes, in any dimension: what
// hierarchies are made from.
//
// Built by the surface-area heuristic (in the plane: perimeter), deterministic, and invariant when
// a scene is multiplied by a power of two.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/shape.h"

namespace wander {

// When a node of the tree stays a leaf.
struct LeafRule {
  std::size_t small;  // so many primitives are never split
  std::size_t large;  // more are always split, by the median if the heuristic sees no gain
  double node_cost;   // of visiting a node, in units of a primitive's intersection
};

template <World W>
struct BoxTree {
  struct Node {
    Box<W> box;
    std::int32_t first = 0;  // of its elements in a leaf, of its two children otherwise
    std::int32_t count = 0;  // of its elements; 0 in an inner node
  };
  static constexpr int depth_limit = 60;

  std::vector<Node> nodes;  // the first is the root
  std::vector<Element<W>> elements;
};

template <World W>
double boundary(const Box<W>& box) {
  return static_cast<double>(W::Dimension::boundary(box.high - box.low));
}

template <World W>
BoxTree<W> box_tree(std::span<const Shape<W>> shapes, LeafRule rule);

}  // namespace wander
