// What a mutation is: it proposes, and does nothing else.  It knows no film, no statistics and no
// log; it is immutable, all randomness comes from `random` and all memory is that of the paths.
#pragma once

#include <concepts>
#include <string_view>

#include "core/path_space.h"
#include "mlt/proposal.h"

namespace wander {

// propose() writes the proposed path into y, which may hold anything before, and leaves x alone.
// applicability() is ≥ 0, and 0 where the mutation cannot act; a mixture selects in proportion.
template <class M, class Space, class Random>
concept Mutation = PathSpace<Space> &&
    requires(const M& mutation, const Space& space, const Path<typename Space::Universe>& x,
             Path<typename Space::Universe>& y, Random& random) {
  { M::name } -> std::convertible_to<std::string_view>;
  { mutation.applicability(space, x) } -> std::convertible_to<double>;
  { mutation.propose(space, x, y, random) } -> std::same_as<Proposed>;
};

}  // namespace wander
