#include "scenes/format/build_scene.cpp"
#include "tests/support/extended_world.h"

namespace wander {

template std::unique_ptr<const Scene<test::FlatlandExtended>> build_flatland(
    const description::Scene&);

}  // namespace wander
