// The tree of boxes itself: its depth, and where its elements are.  What it finds: bvh_test.cpp.
#include "core/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wander::test::box_tree_test {
namespace {

using W = Flatland;
using Tree = BoxTree<W>;
constexpr LeafRule rule{.small = 1, .large = 4, .node_cost = 1};

int depth_of(const Tree& tree, std::size_t node = 0) {
  const Tree::Node& at = tree.nodes[node];
  if (at.count > 0) return 0;
  const auto child = static_cast<std::size_t>(at.first);
  return 1 + std::max(depth_of(tree, child), depth_of(tree, child + 1));
}

// Each half as large as the one before, and half as far: the best split takes the largest from all others.
Tree of_halves(int count, double sign) {
  std::vector<Shape<W>> shapes;
  for (int k = 0; k < count; ++k) {
    const double x = sign * std::ldexp(1.0, -k);
    shapes.push_back(Segment<W>({x, 0}, {x, std::abs(x) / 64}));
  }
  return box_tree<W>(shapes, rule);
}

// Whoever walks through it has room for so many nodes.
TEST(BoxTree, IsNoDeeperThanItsLimit) {
  for (const double sign : {1.0, -1.0}) {  // to the first child, or to the second
    const Tree deep = of_halves(400, sign);
    EXPECT_EQ(depth_of(deep), Tree::depth_limit);
    EXPECT_EQ(deep.elements.size(), 400u);
  }
}

}  // namespace
}  // namespace wander::test::box_tree_test
