// The module `wanderlight._wander`: the engine as the package wanderlight uses it.  What users see,
// and its documentation, is the package.
#include "python/binding/bindings.h"
#include "python/binding/errors.h"

NB_MODULE(_wander, module) {
  using namespace wander::python;
  module.doc() = "The engine of Wanderlight; the package wanderlight is how it is used.";
  translate_errors(module);
  bind_tables(module);
  bind_scene(module);
  bind_record(module);
  bind_run(module);
  bind_trace(module);
  bind_comparison(module);
  bind_verbs(module);
}
