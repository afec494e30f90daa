// What a run found, as a value that adds: the findings of runs of one job with different seeds,
// added, are those of one run that did the work of all.
#pragma once

#include "records/rendering.h"

namespace wander {

class Findings {
 public:
  virtual ~Findings() = default;

  // What was added may refer to its run, until this call makes it the findings' own.
  virtual void keep() {}
  // All that has come out, but for facts of the execution.
  virtual Rendering rendering() const = 0;
};

}  // namespace wander
