#include "scenes/format/build_scene.cpp"
#include "tests/support/extended_world.h"

namespace wander {

template std::unique_ptr<const Scene<test::FlatlandExtended>> build_scene(
    const description::Scene&);
template std::unique_ptr<const Scene<test::SpacelandExtended>> build_scene(
    const description::Scene&);
template std::unique_ptr<const Scene<test::SpacelandSingle>> build_scene(const description::Scene&);

}  // namespace wander
