#include "core/geometry/box_tree.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <optional>

namespace wander {

namespace {

// More parts than these are not sorted to be split, but put into bins.
constexpr std::size_t most_swept = 1024, bin_count = 32;

template <World W>
Box<W> join(const Box<W>& a, const Box<W>& b) {
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
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

template <World W>
struct Builder {
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

  std::span<const Shape<W>> shapes;
  LeafRule rule;
  BoxTree<W> tree{};
  std::vector<Part> parts{};

  void build() {
    std::size_t count = 0;
    for (const Shape<W>& shape : shapes) count += static_cast<std::size_t>(primitives<W>(shape));
    parts.reserve(count);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Shape<W>& shape = shapes[i];
      for (std::int32_t k = 0; k < primitives<W>(shape); ++k)
        parts.push_back({padded<W>(wander::bounds<W>(shape, k)), static_cast<ShapeId>(i), k});
    }
    tree.elements.reserve(count);
    tree.nodes.reserve(count);  // more than are needed, and what is not touched costs nothing
    tree.nodes.emplace_back();
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
    const auto center = [axis](const Part& part) { return part.center(axis); };
    const auto [first, last] = std::ranges::minmax_element(range, {}, center);
    return {axis, center(*first), center(*last) - center(*first)};
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
      std::partition(range.begin(), range.end(),
                     [&](const Part& part) { return chosen.bin_of(part) < border; });
    return best;
  }

  // With the parts in its order; of none where a leaf is better.
  Split best_split(std::span<Part> range, double whole) const {
    const bool many = range.size() > most_swept;
    Split split = many ? binned_split(range) : swept_split(range);
    const bool gains =
        split.cost + rule.node_cost * whole < whole * static_cast<double>(range.size());
    if (!gains && range.size() <= rule.large) return {};
    if (!gains) split = {0, split.axis, range.size() / 2};
    if (!gains || !many) sort(range, split.axis);
    return split;
  }

  void make_leaf(std::size_t node, std::span<const Part> range) {
    tree.nodes[node].first = static_cast<std::int32_t>(tree.elements.size());
    tree.nodes[node].count = static_cast<std::int32_t>(range.size());
    for (const Part& part : range) tree.elements.push_back(element_of(part));
  }
  static Element<W> element_of(const Part& part) {
    if constexpr (std::is_empty_v<PrimitiveId<W>>)
      return part.shape;
    else
      return Element<W>(part.shape, part.primitive);
  }

  void fill(std::size_t node, std::span<Part> range, int depth) {
    tree.nodes[node].box = bounds(range);
    if (range.size() <= rule.small || depth == BoxTree<W>::depth_limit)
      return make_leaf(node, range);
    const Split split = best_split(range, boundary(tree.nodes[node].box));
    if (split.count == 0) return make_leaf(node, range);

    const std::size_t child = tree.nodes.size();
    tree.nodes[node].first = static_cast<std::int32_t>(child);
    tree.nodes.resize(child + 2);
    fill(child, range.first(split.count), depth + 1);
    fill(child + 1, range.subspan(split.count), depth + 1);
  }
};

}  // namespace

template <World W>
BoxTree<W> box_tree(std::span<const Shape<W>> shapes, LeafRule rule) {
  Builder<W> builder{shapes, rule};
  builder.build();
  return std::move(builder.tree);
}

template BoxTree<Flatland> box_tree(std::span<const Shape<Flatland>>, LeafRule);
template BoxTree<FlatlandSingle> box_tree(std::span<const Shape<FlatlandSingle>>, LeafRule);
template BoxTree<Spaceland> box_tree(std::span<const Shape<Spaceland>>, LeafRule);
template BoxTree<SpacelandColour> box_tree(std::span<const Shape<SpacelandColour>>, LeafRule);

}  // namespace wander
