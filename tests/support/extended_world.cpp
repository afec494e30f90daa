#include "tests/support/extended_world.h"

// The definitions that the program makes for its own worlds.
#include "core/conductor.cpp"
#include "core/geometry/box_tree.cpp"
#include "core/geometry/bvh.cpp"
#include "core/geometry/shapes_flat.cpp"
#include "core/material.cpp"
#include "core/scene.cpp"
#include "core/transport.cpp"

namespace wander {

template class ComplexIndex<test::FlatlandExtended>;
template class Segment<test::FlatlandExtended>;
template class Arc<test::FlatlandExtended>;
template BoxTree<test::FlatlandExtended> box_tree(std::span<const Shape<test::FlatlandExtended>>,
                                                  LeafRule);
template class Bvh<test::FlatlandExtended>;
template class Scene<test::FlatlandExtended>;
template class Transport<test::FlatlandExtended>;

}  // namespace wander
