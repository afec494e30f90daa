// What there is to say against a run that its methods cannot know: of its scene, its machine and its
// threads.
#pragma once

#include <string>

#include "lab/scene_source.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

// Those of the scene come first.
void add_warnings(Rendering& rendering, const Session& session, const SceneDocument& document,
                  const std::string& source);

}  // namespace wander
