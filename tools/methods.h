// The methods of `render` by name: the one place where a name becomes an algorithm.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/description.h"
#include "core/rendering.h"
#include "core/session.h"
#include "mutations/catalogue.h"

namespace wander {

// pt, lt, bdpt, mlt, pssmlt, mmlt, pt-naive, lt-naive.
std::span<const std::string_view> method_names();

// What the steps of pssmlt and mmlt deposit (mlt/primary_estimator.h).  The usual of pssmlt is
// Kelemen's, as published; that of mmlt is expected values.
enum class StepEstimator { usual, kelemen, expected };
inline constexpr std::array<std::string_view, 2> estimator_words{"kelemen", "expected"};

// `method` is one of method_names(); `weights` belongs to mlt, `estimator` to pssmlt and mmlt.
// Throws std::runtime_error.
Rendering render(const description::Scene& scene, std::string_view method,
                 const MutationWeights& weights, const Session& session,
                 StepEstimator estimator = StepEstimator::usual);

}  // namespace wander
