#include "core/geometry/bvh.h"

#include <array>

namespace wander {

template <World W>
Bvh<W>::Bvh(std::span<const Shape<W>> shapes) : shapes_(shapes) {
  constexpr LeafRule few_primitives_are_one_leaf{.small = 4, .large = 16, .node_cost = 3};
  BoxTree<W> tree = box_tree<W>(shapes, few_primitives_are_one_leaf);
  nodes_ = std::move(tree.nodes);
  items_.reserve(tree.elements.size());
  for (const Element<W> element : tree.elements) items_.emplace_back(shapes, element);
}

namespace {

// Distance at which the ray enters the box, or infinity.  The exit is widened by the rounding of
// the slab test (Ize 2013), so no shape inside is missed.
template <World W>
typename W::Length enter(const Box<W>& box, const Ray<W>& ray, const typename W::Direction& inverse,
                         typename W::Length limit) {
  using Length = typename W::Length;
  Length near = 0, far = limit;
  for (int axis = 0; axis < W::dimension; ++axis) {
    const Length a = (box.low[axis] - ray.origin[axis]) * inverse[axis];
    const Length b = (box.high[axis] - ray.origin[axis]) * inverse[axis];
    // Written so that NaN (a ray within a slab's plane) leaves the interval as it is.
    const Length low = a < b ? a : b, high = a < b ? b : a;
    near = low > near ? low : near;
    const Length widened = high * (1 + 4 * std::numeric_limits<Length>::epsilon());
    far = widened < far ? widened : far;
  }
  return near <= far ? near : std::numeric_limits<Length>::infinity();
}

}  // namespace

template <World W>
template <class Leaf>
void Bvh<W>::traverse(const Ray<W>& ray, Leaf&& leaf) const {
  if (nodes_.size() == 1) {
    leaf(nodes_.front(), ray.limit);
    return;
  }
  const typename W::Direction inverse = Length(1) / ray.direction;
  struct Entry {
    std::int32_t node;
    Length distance;
  };
  std::array<Entry, BoxTree<W>::depth_limit + 4> stack;
  std::size_t height = 0;
  Length limit = ray.limit;
  stack[height++] = {0, 0};
  while (height > 0) {
    const Entry entry = stack[--height];
    if (entry.distance > limit) continue;
    const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
    if (node.count > 0) {
      limit = leaf(node, limit);
      continue;
    }
    const auto enter_child = [&](std::int32_t child) -> Entry {
      return {child, enter(nodes_[static_cast<std::size_t>(child)].box, ray, inverse, limit)};
    };
    Entry near = enter_child(node.first), far = enter_child(node.first + 1);
    if (far.distance < near.distance) std::swap(near, far);
    constexpr Length never = std::numeric_limits<Length>::infinity();
    if (far.distance < never) stack[height++] = far;
    if (near.distance < never) stack[height++] = near;
  }
}

template <World W>
Hit<W> Bvh<W>::closest(const Ray<W>& ray) const {
  Hit<W> hit;
  ReadyRay<W> shortened = ray;
  traverse(ray, [&](const Node& leaf, Length limit) {
    shortened.limit = limit;
    for (std::int32_t i = 0; i < leaf.count; ++i) {
      const BvhItem<W>& item = items_[static_cast<std::size_t>(leaf.first + i)];
      const Length found = distance(item, shortened);
      if (found < shortened.limit) {
        shortened.limit = found;
        hit = {item.element.shape, found, item.element.primitive};
      }
    }
    return shortened.limit;
  });
  return hit;
}

template <World W>
bool Bvh<W>::any(const Ray<W>& ray) const {
  bool found = false;
  const ReadyRay<W>& ready = ray;
  traverse(ray, [&](const Node& leaf, Length limit) {
    for (std::int32_t i = 0; i < leaf.count && !found; ++i)
      found = distance(items_[static_cast<std::size_t>(leaf.first + i)], ready) < ray.limit;
    return found ? Length(-1) : limit;
  });
  return found;
}

template class Bvh<Flatland>;
template class Bvh<FlatlandSingle>;
template class Bvh<Spaceland>;
template class Bvh<SpacelandColour>;

}  // namespace wander
