#include "core/geometry/wide_bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace wander {

namespace {

constexpr float never = std::numeric_limits<float>::infinity();

// By at least so much the conversion to single precision rounds.
float rounding(float nearest) {
  return std::abs(nearest) * std::numeric_limits<float>::epsilon() +
         std::numeric_limits<float>::min();
}
float rounded_down(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest - rounding(nearest);
}
float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  return nearest + rounding(nearest);
}

// The largest power of two that a normal number is not below, and its inverse.
struct PowerOfTwo {
  double value, inverse;

  explicit PowerOfTwo(double x) {
    constexpr std::uint64_t exponent = 0x7FF0'0000'0000'0000, of_two = 0x7FE0'0000'0000'0000;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) & exponent;
    value = std::bit_cast<double>(bits);
    inverse = std::bit_cast<double>(of_two - bits);
  }
};

}  // namespace

// ---- construction: several levels of a binary tree become one

template <World W>
struct WideBvh<W>::Builder {
  using Tree = BoxTree<W>;
  using TreeNode = typename Tree::Node;

  const Tree& tree;
  WideBvh& bvh;

  const TreeNode& at(std::int32_t node) const { return tree.nodes[static_cast<std::size_t>(node)]; }

  void build() {
    const Box<W>& all = tree.nodes.front().box;
    bvh.center_ = all.low + (all.high - all.low) / Length(2);
    Length extent = 0;
    for (int axis = 0; axis < W::dimension; ++axis)
      extent = std::max(extent, all.high[axis] - all.low[axis]);
    bvh.scale_ = std::ldexp(Length(1), -std::ilogb(extent));
    if (at(0).count == 0) fill(add_node(), 0);
  }

  std::int32_t add_node() {
    Node node;
    // Empty boxes are entered by nothing but a ray whose origin has no number in single precision, which enters all.
    node.children.fill({0, 1});
    for (auto& planes : node.planes) {
      planes[low] = Lanes{} + never;
      planes[high] = Lanes{} - never;
    }
    bvh.nodes_.push_back(node);
    return static_cast<std::int32_t>(bvh.nodes_.size()) - 1;
  }

  // The nodes of the tree that become children: the largest is opened as long as there is room.
  std::vector<std::int32_t> opened(std::int32_t root) const {
    std::vector<std::int32_t> open{at(root).first, at(root).first + 1};
    while (open.size() < width) {
      std::int32_t* largest = nullptr;
      for (std::int32_t& node : open)
        if (at(node).count == 0 &&
            (!largest || boundary(at(node).box) > boundary(at(*largest).box)))
          largest = &node;
      if (!largest) break;
      const std::int32_t first = at(*largest).first;
      *largest = first;
      open.push_back(first + 1);
    }
    return open;
  }

  void fill(std::int32_t node, std::int32_t from) {
    std::size_t lane = 0;
    for (const std::int32_t part : opened(from)) {
      set_box(bvh.nodes_[static_cast<std::size_t>(node)], lane, at(part).box);
      Child child{at(part).first, at(part).count};
      if (child.count == 0) {
        child.first = add_node();
        fill(child.first, part);
      }
      bvh.nodes_[static_cast<std::size_t>(node)].children[lane++] = child;
    }
  }

  void set_box(Node& node, std::size_t lane, const Box<W>& box) const {
    for (int axis = 0; axis < W::dimension; ++axis) {
      auto& planes = node.planes[static_cast<std::size_t>(axis)];
      planes[low][lane] = rounded_down((box.low[axis] - bvh.center_[axis]) * bvh.scale_);
      planes[high][lane] = rounded_up((box.high[axis] - bvh.center_[axis]) * bvh.scale_);
    }
  }
};

namespace {

// Boxes cost a ray little, so leaves are small; of many primitives they would take more memory than
// the primitives, and each is entered less often.
LeafRule leaf_rule(std::size_t primitives) {
  constexpr std::size_t few = 4096;
  return {
      .small = primitives <= few ? std::size_t{1} : std::size_t{4}, .large = 8, .node_cost = 0.3};
}

}  // namespace

template <World W>
WideBvh<W>::WideBvh(std::span<const Shape<W>> shapes) : shapes_(shapes) {
  std::size_t count = 0;
  for (const Shape<W>& shape : shapes) count += static_cast<std::size_t>(primitives<W>(shape));
  BoxTree<W> tree = box_tree<W>(shapes, leaf_rule(count));
  if (!tree.elements.empty()) Builder{tree, *this}.build();
  elements_ = std::move(tree.elements);
}

// ---- traversal

// A ray against the boxes of a node, with a direction of the order of one: single precision would hold
// neither its length nor its inverse where a scene is large or small.
template <World W>
struct WideBvh<W>::Slabs {
  struct Axis {
    int near, far;          // which planes the ray meets first, and last: those of a Side
    float to_near, to_far;  // the origin, rounded so that distances become less, and more
    float inverse;          // of the direction
  };
  std::array<Axis, W::dimension> axes;
  Length unit;  // of distances: so many of that direction are one of the ray's

  // Of (plane - origin) · inverse each step rounds once: relative errors of up to 3 ε/2, for the
  // entry and for the exit; the limit is rounded once more.
  static constexpr float widening = 1 + 8 * std::numeric_limits<float>::epsilon();

  Slabs(const Ray<W>& ray, const Point& center, Length scale) {
    Length size = 0;
    for (int axis = 0; axis < W::dimension; ++axis) size += std::abs(ray.direction[axis]);
    const PowerOfTwo length(size);
    unit = scale * length.value;
    for (int axis = 0; axis < W::dimension; ++axis) {
      const auto origin = static_cast<float>((ray.origin[axis] - center[axis]) * scale);
      const auto inverse = static_cast<float>(1 / (ray.direction[axis] * length.inverse));
      // Directions are as good as random, so what hangs on their signs is computed and not branched to.
      const int falls = std::signbit(inverse);
      const float outwards = std::copysign(rounding(origin), inverse);
      axes[static_cast<std::size_t>(axis)] = {falls, 1 - falls, origin + outwards,
                                              origin - outwards, inverse};
    }
  }

  // What is farther along the ray is of no interest.
  float limit(Length distance) const { return static_cast<float>(distance * unit) * widening; }

  // Where the ray enters each box; never, if not before `limit`.
  Lanes enter(const Node& node, float limit) const {
    Lanes near{}, far = Lanes{} + limit;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const Axis& axis = axes[i];
      const Lanes first = (node.planes[i][axis.near] - axis.to_near) * axis.inverse;
      const Lanes last = (node.planes[i][axis.far] - axis.to_far) * axis.inverse;
      // Written so that NaN (a ray within a slab's plane) leaves the interval as it is.
      near = first > near ? first : near;
      far = last < far ? last : far;
    }
    return near <= far * widening ? near : Lanes{} + never;
  }
};

template <World W>
template <class Leaf>
void WideBvh<W>::traverse(const Ray<W>& ray, Leaf&& leaf) const {
  if (nodes_.empty()) {
    leaf(Child{0, static_cast<std::int32_t>(elements_.size())}, ray.limit);
    return;
  }
  const Slabs slabs(ray, center_, scale_);
  struct Entry {
    Child child;
    float distance;
  };
  std::array<Entry, BoxTree<W>::depth_limit*(width - 1) + 1> stack;
  std::size_t height = 0;
  Length limit = ray.limit;
  float limit_of_boxes = slabs.limit(limit);
  Entry entry{{0, 0}, 0};
  for (;;) {
    if (entry.child.count > 0) {
      limit = leaf(entry.child, limit);
      limit_of_boxes = slabs.limit(limit);
    } else {
      const Node& node = nodes_[static_cast<std::size_t>(entry.child.first)];
      const Lanes distances = slabs.enter(node, limit_of_boxes);
      const std::size_t bottom = height;
      for (std::size_t i = 0; i < width; ++i) {
        const float distance = distances[i];
        if (!(distance < never)) continue;
        // The nearest comes to lie on top.
        std::size_t at = height++;
        for (; at > bottom && stack[at - 1].distance < distance; --at) stack[at] = stack[at - 1];
        stack[at] = {node.children[i], distance};
      }
    }
    do {
      if (height == 0) return;
      entry = stack[--height];
    } while (entry.distance > limit_of_boxes);
  }
}

template <World W>
Hit<W> WideBvh<W>::closest(const Ray<W>& ray) const {
  Hit<W> hit;
  ReadyRay<W> shortened = ray;
  traverse(ray, [&](Child leaf, Length limit) {
    shortened.limit = limit;
    for (std::int32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const Element<W> element = elements_[static_cast<std::size_t>(i)];
      const Length found = distance(element, shortened);
      if (found < shortened.limit) {
        shortened.limit = found;
        hit = {element.shape, found, element.primitive};
      }
    }
    return shortened.limit;
  });
  return hit;
}

template <World W>
bool WideBvh<W>::any(const Ray<W>& ray) const {
  bool found = false;
  const ReadyRay<W> ready = ray;
  traverse(ray, [&](Child leaf, Length limit) {
    for (std::int32_t i = leaf.first; i < leaf.first + leaf.count && !found; ++i)
      found = distance(elements_[static_cast<std::size_t>(i)], ready) < ray.limit;
    return found ? Length(-1) : limit;
  });
  return found;
}

template class WideBvh<Spaceland>;
template class WideBvh<SpacelandColour>;

}  // namespace wander
