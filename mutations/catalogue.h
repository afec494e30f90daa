// The mutations by name.  A new one is a file of its own and its place in `Family`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/session.h"
#include "mlt/mixture.h"
#include "mutations/bidirectional.h"
#include "mutations/primary_large.h"
#include "mutations/primary_small.h"

namespace wander {

using Family = Mixture<Bidirectional, PrimarySmall, PrimaryLarge>;

// Of the primary steps, the share that is large.
inline constexpr double default_large_step = 0.3;

// Relative weights by the words of --mutations; `primary` is both of its steps.  Empty: all.
using MutationWeights = std::vector<std::pair<std::string, double>>;
inline constexpr std::array<std::string_view, 2> mutation_words{"bidirectional", "primary"};

// The mixture for paths of up to `max_vertices` vertices; words and weights are valid.
Family make_family(const MutationWeights& weights, int max_vertices);

}  // namespace wander
