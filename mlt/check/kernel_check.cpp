#include "mlt/check/kernel_check.h"

namespace wander {

Verdict verdict_of(const InvarianceReport& report) {
  Verdict verdict = Verdict::untested;
  for (const Decision* d : {&report.one_step, &report.many_steps, &report.flux}) {
    if (d->comparisons == 0) continue;
    if (!d->passed) return Verdict::failed;
    verdict = Verdict::passed;
  }
  return verdict;
}

}  // namespace wander
