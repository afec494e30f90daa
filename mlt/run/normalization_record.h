// What is said of the normalization constant b, the mean of the film.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

struct NormalizationEstimate : Estimate {
  std::uint64_t samples = 0;      // of the seed pass
  double degrees_of_freedom = 0;  // of the t-interval around it
  std::string failure{};          // why there is none; empty if there is
};

struct LengthShare : Estimate {
  int vertices = 0;
};

struct Normalization : Estimate {  // b, the mean of the film
  std::string method{};            // the estimate that `value` is
  std::map<std::string, NormalizationEstimate> estimates{};
  std::vector<LengthShare> by_length{};  // sums to `value`
};

}  // namespace wander
