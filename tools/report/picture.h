// Films of scenes in space: images, as tones side by side.
#pragma once

#include "tools/report/html.h"
#include "tools/report/subject.h"

namespace wander::report {

// The reference first, if there is one; all on the same scale.
void write_pictures(Html& html, const Subject& subject);

}  // namespace wander::report
