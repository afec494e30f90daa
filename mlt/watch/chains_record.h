// What is said of the mutations and of the mixing of some chains.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// What became of the proposals made while a chain was at a path of this length, or class.
struct PathsRecord {
  int vertices = 0;          // by length
  std::string path_class{};  // by class, such as LDSE
  std::uint64_t proposed = 0, accepted = 0;
  double mean_acceptance = 0;
  std::map<std::string, std::uint64_t> failures{};
};

struct MutationRecord {
  std::string name{};
  std::uint64_t proposed = 0, accepted = 0;
  double mean_acceptance = 0;                       // mean of a(x -> y) over all proposals
  std::map<std::string, std::uint64_t> failures{};  // reason -> count
  std::vector<double> proposed_per_bin{};           // proposals made while the path was in this bin
  std::vector<double> acceptance_per_bin{};         // mean acceptance of those proposals
  double seconds = not_known;       // of all threads together, from a sample of the steps
  double squared_jump = not_known;  // mean of a |film(y) - film(x)|², the film being [0,1)^(D-1)
  std::uint64_t longest_rejection_run = 0;  // of one chain: proposals of this mutation alone
  std::vector<PathsRecord> by_length{}, by_class{};
};

// How well the chains know a scalar of their states; NaN where nothing can be told.
struct FunctionalRecord {
  std::string name{};
  double r_hat = not_known, ess_bulk = not_known, ess_tail = not_known;
  double autocorrelation_time = not_known;  // integrated; in mutations of one chain
};

struct ChainsRecord {
  std::uint64_t draws = 0, stride = 1;      // of each chain: so many states, so many steps apart
  std::uint64_t longest_rejection_run = 0;  // of one chain: steps without a move
  std::vector<FunctionalRecord> functionals{};
};

}  // namespace wander
