// Do the methods agree?  Each film is held against that of bidirectional path tracing, bin by bin,
// where both are reliable, by Welch's test on the error bars that the methods themselves state.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/description.h"
#include "lab/dials.h"
#include "mlt/check/kernel_check.h"
#include "records/rendering.h"
#include "statistics/decision.h"
#include "work/session.h"

namespace wander {

inline constexpr std::string_view reference_method = "bdpt";

struct MethodCheck {
  std::string method;
  Verdict verdict = Verdict::untested;
  std::string reason{};  // why it is untested
  Decision decision{};
  std::size_t bins = 0;  // of the film; the decision compares the reliable ones
};

// The methods that are held against the reference; mlt among them.
std::vector<std::string_view> checked_methods();

// Films are equal within their errors; `worst` is a bin.
MethodCheck compare_films(std::string method, const FilmEstimate& film,
                          const FilmEstimate& reference, double false_alarm);

// Renders the scene with each method, its dials and `session`'s budget.  Calls done() after each of
// the renderings.  The reference is made in double precision.
std::vector<MethodCheck> check_methods(const description::Scene& scene, const Dials& dials,
                                       const Session& session, double false_alarm,
                                       const std::function<void()>& done);

}  // namespace wander
