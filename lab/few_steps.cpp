#include "lab/few_steps.h"

#include <variant>

#include "mlt/run/partition.h"

namespace wander {

bool is_of_few_steps(const Budget& budget, const Job& job) {
  const auto* count = std::get_if<SampleBudget>(&budget);
  const ChainSettings& chains = job.dials().chains;
  return count && job.method().is_markov_chain() && chains.film_parts == FilmParts::pooled &&
         static_cast<double>(chains.fewest_seeds) >
             fewest_samples_per_step * static_cast<double>(count->samples);
}

}  // namespace wander
