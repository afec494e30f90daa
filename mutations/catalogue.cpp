#include "mutations/catalogue.h"

namespace wander {

Family make_family(const MutationWeights& weights, int max_vertices) {
  double bidirectional = weights.empty() ? 1 : 0, primary = bidirectional;
  for (const auto& [word, weight] : weights) {
    if (word == "bidirectional") bidirectional = weight;
    if (word == "primary") primary = weight;
  }
  return Family({bidirectional, (1 - default_large_step) * primary, default_large_step * primary},
                Bidirectional{}, PrimarySmall{}, PrimaryLarge(max_vertices));
}

}  // namespace wander
