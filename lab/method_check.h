// Do the methods agree?  Each film is held against that of bidirectional path tracing, bin by bin,
// where both are reliable, by Welch's test on the error bars that the methods themselves state.  A
// bin takes part if the test could fail there: of errors of few degrees of freedom it never does.
// Images are rendered with pixels of their own for it, 16 along the longer side at most.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/job.h"
#include "mlt/check/kernel_check.h"
#include "records/rendering.h"
#include "statistics/decision.h"
#include "work/session.h"

namespace wander {

struct MethodCheck {
  std::string method;
  Verdict verdict = Verdict::untested;
  std::string reason{};  // why it is untested
  Decision decision{};
  std::size_t bins = 0;  // of the film; the decision compares the reliable ones
};

// Films are equal within their errors; `worst` is a bin.
MethodCheck compare_films(std::string method, const FilmEstimate& film,
                          const FilmEstimate& reference, double false_alarm);

// Renders the scene of the job with the reference method, all dials as usual, then with each of the
// checked_methods() and the dials of the job, each with `session`'s budget.  Calls done() after each
// of the renderings.
std::vector<MethodCheck> check_methods(const Job& job, const Session& session, double false_alarm,
                                       const std::function<void()>& done);

}  // namespace wander
