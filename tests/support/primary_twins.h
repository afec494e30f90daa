// Small steps in one coordinate that do something else at the ends of [0,1) than wrap around; and
// the same that wraps, which must pass where its twins are caught.
#pragma once

#include <algorithm>
#include <cmath>

#include "mutations/kelemen.h"

namespace wander::test {

enum class AtTheEnds { wrap, clamp, resample, redraw };

// Kelemen's step, with a range so large that it often meets the ends.
struct FarStep {
  AtTheEnds rule = AtTheEnds::wrap;
  Kelemen kernel{1.0 / 64, 0.4};

  template <class Random>
  Kelemen::Move move(double u, Random& random) const {
    for (;;) {
      const Kelemen::Move wrapped = kernel.move(u, random);
      if (std::abs(wrapped.u - u) < 0.5 || rule == AtTheEnds::wrap) return wrapped;
      if (rule == AtTheEnds::clamp)
        return {wrapped.u < u ? std::nextafter(1.0, 0.0) : 0.0, wrapped.density};
      if (rule == AtTheEnds::resample) return {random.uniform(), wrapped.density};
    }
  }
};

}  // namespace wander::test
