// What a mutation answers: a proposed path with both transition densities, or the reason why there
// is none.  A failure is a rejection: it is counted, and the chain stays where it is.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "core/scaled.h"

namespace wander {

enum class Reason {
  none,           // accepted
  metropolis,     // proposed, and refused by the acceptance test
  occluded,       // a connection is blocked, or its ends face away from each other
  missed_scene,   // a walk ended before it was long enough
  changed_class,  // a specular vertex where a connection was needed
  too_long,
  zero_contribution,  // f(y) = 0
  not_reversible,     // y → x cannot happen
  outside_range,
  solver_failed,
  not_finite,
  not_applicable,  // no mutation of the mixture can act on this path
};
inline constexpr std::array<std::string_view, 12> reason_names{
    "none",          "metropolis",    "occluded",          "missed_scene",
    "changed_class", "too_long",      "zero_contribution", "not_reversible",
    "outside_range", "solver_failed", "not_finite",        "not_applicable"};

inline std::string_view name_of(Reason reason) {
  return reason_names[static_cast<std::size_t>(reason)];
}

// Densities of x→y and y→x with respect to the area product, complete: nothing that cancels in the
// acceptance ratio is left out.
struct Proposal {
  Scaled forward, reverse;
};
struct Failure {
  Reason reason;
};
using Proposed = std::variant<Proposal, Failure>;

}  // namespace wander
