// The program's exceptions as those of the module `errors` of the package, with the same messages.
#pragma once

#include <nanobind/nanobind.h>

namespace wander::python {

void translate_errors(const nanobind::module_& module);

}  // namespace wander::python
