// The program's exceptions as those of wanderlight.errors, with the same messages.
#pragma once

namespace wander::python {

void translate_errors();

}  // namespace wander::python
