// The mutations by name.  A new one is a file of its own, included here, and its place in `Family`;
// what it says of itself beside proposing is in its Traits (mlt/traits.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/requirements.h"
#include "mlt/mixture.h"
#include "mutations/bidirectional.h"
#include "mutations/caustic.h"
#include "mutations/lens.h"
#include "mutations/multichain.h"
#include "mutations/own_mutations.h"
#include "mutations/primary_large.h"
#include "mutations/primary_small.h"

namespace wander {

using UsualFamily = Mixture<Bidirectional, Lens, Caustic, Multichain, PrimarySmall, PrimaryLarge>;
// With those that whoever builds the program brings (docs/extending.md, mutations/CMakeLists.txt).
using Family = Joined<UsualFamily, OwnMutations>;

// The words of --mutations, each once.
std::vector<std::string_view> mutation_words();

// A parameter of a mutation as people read it; `smallest` and `largest` are the usual ones, the
// same number twice where it is no range.
struct ParameterFacts {
  std::string_view name, meaning;
  double smallest = 0, largest = 0, most = 0;
  bool is_range() const { return smallest != largest; }
};
// Of the mutations that go by a word.
std::vector<ParameterFacts> parameters_of(std::string_view word);

// A parameter that was set.
struct ParameterSetting {
  std::string name;
  double smallest = 0, largest = 0;
  friend bool operator==(const ParameterSetting&, const ParameterSetting&) = default;
};

// A word with its relative weight, and what was set.
struct MutationWeight {
  std::string word;
  double weight = 0;
  std::vector<ParameterSetting> parameters{};
  friend bool operator==(const MutationWeight&, const MutationWeight&) = default;
};
// Words that are not there weigh nothing.
using MutationWeights = std::vector<MutationWeight>;

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
  double kernel = 1;  // a factor on how far small moves go, where it is not set
};

// The mixture for paths of up to `max_vertices` vertices.  No weights: every mutation.
Family make_family(const FamilySettings& settings, int max_vertices);
// The mixture for a scene.  No weights: what `auto` makes of it.
Family make_family(const FamilySettings& settings, const Requirements& scene);

}  // namespace wander
