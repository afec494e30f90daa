#include "tests/support/extended_world.h"

// The definitions that the program makes for its own worlds.
#include "core/conductor.cpp"
#include "core/geometry/box_tree.cpp"
#include "core/geometry/bvh.cpp"
#include "core/geometry/mesh.cpp"
#include "core/geometry/shapes_space.cpp"
#include "core/geometry/wide_bvh.cpp"
#include "core/material.cpp"
#include "core/scene.cpp"
#include "core/transport.cpp"

namespace wander {

template class WideBvh<test::SpacelandSingle>;
template class Bvh<test::SpacelandExtended>;
#define WANDER_SPACE(World)                                                  \
  template class ComplexIndex<World>;                                        \
  template class Mesh<World>;                                                \
  template class Sphere<World>;                                              \
  template class Parallelogram<World>;                                       \
  template BoxTree<World> box_tree(std::span<const Shape<World>>, LeafRule); \
  template class Scene<World>;                                               \
  template class Transport<World>;
WANDER_SPACE(test::SpacelandSingle)
WANDER_SPACE(test::SpacelandExtended)
#undef WANDER_SPACE

}  // namespace wander
