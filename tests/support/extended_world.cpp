#include "tests/support/extended_world.h"

// The definitions that the program makes for its own worlds.
#include "core/bvh.cpp"
#include "core/material.cpp"
#include "core/scene.cpp"
#include "core/shapes_flat.cpp"
#include "core/transport.cpp"

namespace wander {

template class Segment<test::FlatlandExtended>;
template class Arc<test::FlatlandExtended>;
template class Bvh<test::FlatlandExtended>;
template class Scene<test::FlatlandExtended>;
template class Transport<test::FlatlandExtended>;

}  // namespace wander
