// What is said of the mutations by word: which there are, what `auto` takes, how they act.  Nothing
// here knows their types (catalogue.h): what includes this alone is the same for any family.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/requirements.h"
#include "mutations/primary.h"

namespace wander {

// The words of --mutations, each once.
std::vector<std::string_view> mutation_words();
// The weight of such a word where none is asked for.
double auto_weight_of(std::string_view word);

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

// Several may go by one word.
int count_of_mutations();
// Those that make_family (catalogue.h) would take for a scene, in its order.
std::vector<std::string_view> names_taken(const FamilySettings& settings,
                                          const Requirements& scene);

}  // namespace wander
