// The mutations by name.  A new one is a file of its own, included here, and its place in `Family`.
//
// Beside what every mutation has (mlt/mutation.h), one may say
// - `word`, of --mutations, that it goes by if not by its name; a word may stand for several;
// - `share(large_step)`, its part of that word's weight, if not 1;
// - `scaled(factor)`, the same mutation with moves so many times as far, if it moves a little;
// - `auto_weight`, of its word where the weights are `auto`, if not 1;
// - `left_out(scene)`, why a scene has no use for it; empty if it has.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/requirements.h"
#include "mlt/mixture.h"
#include "mutations/bidirectional.h"
#include "mutations/caustic.h"
#include "mutations/lens.h"
#include "mutations/multichain.h"
#include "mutations/primary_large.h"
#include "mutations/primary_small.h"

namespace wander {

using Family = Mixture<Bidirectional, Lens, Caustic, Multichain, PrimarySmall, PrimaryLarge>;

// The words of --mutations, each once.
std::vector<std::string_view> mutation_words();

// Relative weights by word; words that are not there weigh nothing.
using MutationWeights = std::vector<std::pair<std::string, double>>;

// What `auto` makes of a scene: the mutations it takes, and why it leaves out the others.
struct MutationChoice {
  MutationWeights weights{};
  std::vector<std::string> taken{};
  std::map<std::string, std::string> left_out{};
};
MutationChoice choose_mutations(const Requirements& scene);

// How the mutations act.
struct FamilySettings {
  MutationWeights weights{};
  double large_step = default_large_step;  // of the primary steps, the share that is large
  double kernel = 1;                       // a factor on how far small moves go
};

// The mixture for paths of up to `max_vertices` vertices.  No weights: every mutation.
Family make_family(const FamilySettings& settings, int max_vertices);
// The mixture for a scene.  No weights: what `auto` makes of it.
Family make_family(const FamilySettings& settings, const Requirements& scene);

}  // namespace wander
