// The mutations by name.  A new one is a file of its own, included here, and its place in `Family`;
// what it says of itself beside proposing is in its Traits (mlt/traits.h).
#pragma once

#include "mlt/mixture.h"
#include "mutations/bidirectional.h"
#include "mutations/caustic.h"
#include "mutations/family_settings.h"
#include "mutations/lens.h"
#include "mutations/multichain.h"
#include "mutations/own_mutations.h"
#include "mutations/primary_large.h"
#include "mutations/primary_small.h"

namespace wander {

using UsualFamily = Mixture<Bidirectional, Lens, Caustic, Multichain, PrimarySmall, PrimaryLarge>;
// With those that whoever builds the program brings (docs/extending.md, mutations/CMakeLists.txt).
using Family = Joined<UsualFamily, OwnMutations>;

// The mixture for paths of up to `max_vertices` vertices.  No weights: every mutation.
Family make_family(const FamilySettings& settings, int max_vertices);
// The mixture for a scene.  No weights: what `auto` makes of it.
Family make_family(const FamilySettings& settings, const Requirements& scene);

}  // namespace wander
