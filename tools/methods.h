// The methods of `render` by name: the one place where a name becomes an algorithm.
#pragma once

#include <span>
#include <string_view>

#include "core/description.h"
#include "core/rendering.h"
#include "core/session.h"
#include "mutations/catalogue.h"

namespace wander {

// pt, lt, bdpt, mlt, pt-naive, lt-naive.
std::span<const std::string_view> method_names();

// `method` is one of method_names(); `weights` belongs to mlt.  Throws std::runtime_error.
Rendering render(const description::Scene& scene, std::string_view method,
                 const MutationWeights& weights, const Session& session);

}  // namespace wander
