// The parts of the module `wanderlight._wander`, each in a file of its own name.
#pragma once

#include <nanobind/nanobind.h>

namespace wander::python {

void bind_tables(nanobind::module_& module);
void bind_scene(nanobind::module_& module);
void bind_record(nanobind::module_& module);
void bind_run(nanobind::module_& module);
void bind_trace(nanobind::module_& module);
void bind_comparison(nanobind::module_& module);
void bind_verbs(nanobind::module_& module);

}  // namespace wander::python
