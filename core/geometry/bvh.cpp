#include "core/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <optional>
#include <ranges>

namespace wander {

namespace {

constexpr int depth_limit = 60;  // of the tree, hence of the stack of a traversal
constexpr int small_leaf = 4;    // never split
constexpr int large_leaf = 16;   // always split, by the median if the heuristic sees no gain
constexpr double node_cost = 3;  // of visiting a node, in units of a primitive's intersection

// More parts than these are not sorted to be split, but put into bins.
constexpr std::size_t most_swept = 1024, bin_count = 32;

template <World W>
Box<W> join(const Box<W>& a, const Box<W>& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

template <World W>
double boundary(const Box<W>& box) {
  return static_cast<double>(W::Dimension::boundary(box.high - box.low));
}

// Bounds hold every point that rounding may produce on the shape.
template <World W>
Box<W> padded(Box<W> box) {
  using Length = typename W::Length;
  const auto reach = glm::max(glm::abs(box.low), glm::abs(box.high));
  Length most = 0;
  for (int axis = 0; axis < W::dimension; ++axis) most = std::max(most, reach[axis]);
  const typename W::Point pad(8 * std::numeric_limits<Length>::epsilon() * most);
  return {box.low - pad, box.high + pad};
}

}  // namespace

template <World W>
struct Bvh<W>::Builder {
  struct Part {
    Box<W> box;
    ShapeId shape;
    std::int32_t primitive;

    auto center(int axis) const { return (box.low[axis] + box.high[axis]) / 2; }
    auto name() const { return std::pair(shape, primitive); }
  };
  struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::size_t count = 0;  // of the parts of the first child, once they are in order
  };
  // The parts whose centres lie in one of equal steps along an axis.
  struct Bin {
    std::optional<Box<W>> box;
    std::size_t count = 0;

    void add(const Box<W>& other, std::size_t parts) {
      box = box ? join(*box, other) : other;
      count += parts;
    }
    double cost() const { return box ? boundary(*box) * static_cast<double>(count) : 0; }
  };
  using Bins = std::array<Bin, bin_count>;
  struct Binning {
    int axis = 0;
    typename W::Length low = 0, extent = 0;

    std::size_t bin_of(const Part& part) const {
      const auto step = (part.center(axis) - low) / extent * bin_count;
      return static_cast<std::size_t>(std::min<typename W::Length>(step, bin_count - 1));
    }
  };

  Bvh& bvh;
  std::vector<Part> parts{};

  void build() {
    std::size_t count = 0;
    for (const Shape<W>& shape : bvh.shapes_)
      count += static_cast<std::size_t>(primitives<W>(shape));
    parts.reserve(count);
    for (std::size_t i = 0; i < bvh.shapes_.size(); ++i) {
      const Shape<W>& shape = bvh.shapes_[i];
      for (std::int32_t k = 0; k < primitives<W>(shape); ++k)
        parts.push_back({padded<W>(wander::bounds<W>(shape, k)), static_cast<ShapeId>(i), k});
    }
    bvh.items_.reserve(count);
    bvh.nodes_.reserve(count);  // more than are needed, and what is not touched costs nothing
    bvh.nodes_.emplace_back();
    if (!parts.empty()) fill(0, parts, 0);
  }

  static Box<W> bounds(std::span<const Part> range) {
    Box<W> box = range.front().box;
    for (const Part& part : range) box = join(box, part.box);
    return box;
  }

  static void sort(std::span<Part> range, int axis) {
    std::ranges::sort(range, [axis](const Part& a, const Part& b) {
      return a.center(axis) != b.center(axis) ? a.center(axis) < b.center(axis)
                                              : a.name() < b.name();
    });
  }

  // Sweep over all positions in sorted order: Σ boundary(side) · count(side).
  static Split swept_split(std::span<Part> range) {
    Split best;
    std::vector<double> right(range.size());
    for (int axis = 0; axis < W::dimension; ++axis) {
      sort(range, axis);
      Box<W> box = range.back().box;
      for (std::size_t i = range.size(); i-- > 1;) {
        box = join(box, range[i].box);
        right[i] = boundary(box) * static_cast<double>(range.size() - i);
      }
      box = range.front().box;
      for (std::size_t i = 1; i < range.size(); ++i) {
        const double cost = boundary(box) * static_cast<double>(i) + right[i];
        if (cost < best.cost) best = {cost, axis, i};
        box = join(box, range[i].box);
      }
    }
    return best;
  }

  static Binning binning(std::span<const Part> range, int axis) {
    const auto [low, high] = std::ranges::minmax(
        range | std::views::transform([axis](const Part& part) { return part.center(axis); }));
    return {axis, low, high - low};
  }

  // The same among the borders of the bins of each axis, and the parts put in order.
  static Split binned_split(std::span<Part> range) {
    Split best;
    Binning chosen;
    std::size_t border = 0;
    for (int axis = 0; axis < W::dimension; ++axis) {
      const Binning by = binning(range, axis);
      if (!(by.extent > 0)) continue;
      Bins bins;
      for (const Part& part : range) bins[by.bin_of(part)].add(part.box, 1);
      std::array<double, bin_count> right;
      Bin side;
      for (std::size_t i = bin_count; i-- > 1;) {
        if (bins[i].box) side.add(*bins[i].box, bins[i].count);
        right[i] = side.cost();
      }
      side = {};
      for (std::size_t i = 1; i < bin_count; ++i) {
        if (bins[i - 1].box) side.add(*bins[i - 1].box, bins[i - 1].count);
        if (side.count == 0 || side.count == range.size()) continue;
        const double cost = side.cost() + right[i];
        if (cost >= best.cost) continue;
        best = {cost, axis, side.count};
        chosen = by;
        border = i;
      }
    }
    if (best.count > 0)
      std::ranges::partition(range, [&](const Part& part) { return chosen.bin_of(part) < border; });
    return best;
  }

  // With the parts in its order; of none where a leaf is better.
  static Split best_split(std::span<Part> range, double whole) {
    const bool many = range.size() > most_swept;
    Split split = many ? binned_split(range) : swept_split(range);
    const bool gains = split.cost + node_cost * whole < whole * static_cast<double>(range.size());
    if (!gains && range.size() <= large_leaf) return {};
    if (!gains) split = {0, split.axis, range.size() / 2};
    if (!gains || !many) sort(range, split.axis);
    return split;
  }

  void make_leaf(std::size_t node, std::span<const Part> range) {
    bvh.nodes_[node].first = static_cast<std::int32_t>(bvh.items_.size());
    bvh.nodes_[node].count = static_cast<std::int32_t>(range.size());
    for (const Part& part : range) bvh.items_.emplace_back(bvh.shapes_, element_of(part));
  }
  static Element<W> element_of(const Part& part) {
    if constexpr (std::is_empty_v<PrimitiveId<W>>)
      return part.shape;
    else
      return Element<W>(part.shape, part.primitive);
  }

  void fill(std::size_t node, std::span<Part> range, int depth) {
    bvh.nodes_[node].box = bounds(range);
    if (range.size() <= small_leaf || depth == depth_limit) return make_leaf(node, range);
    const Split split = best_split(range, boundary(bvh.nodes_[node].box));
    if (split.count == 0) return make_leaf(node, range);

    const std::size_t child = bvh.nodes_.size();
    bvh.nodes_[node].first = static_cast<std::int32_t>(child);
    bvh.nodes_.resize(child + 2);
    fill(child, range.first(split.count), depth + 1);
    fill(child + 1, range.subspan(split.count), depth + 1);
  }
};

template <World W>
Bvh<W>::Bvh(std::span<const Shape<W>> shapes) : shapes_(shapes) {
  Builder{*this}.build();
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
  std::array<Entry, depth_limit + 4> stack;
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
