// What a run computed: the film with its error bars, and for Markov chain methods the normalization
// and the record of each mutation.  Plain data, made by the estimators and read by the writers of
// EXR, CSV and JSON (core/output) and by the figures.
//
// Units: film values are mean irradiance per bin (W/m in 2D) or mean radiance (camera).
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wander {

// A number that cannot be told.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

struct Estimate {
  double value = 0;
  double standard_error = 0;  // one standard deviation of `value`; NaN when it cannot be told
};

struct FilmEstimate {
  std::vector<int> shape{};              // {bins} in 2D, {height, width} in 3D
  std::vector<double> value{};           // per bin
  std::vector<double> standard_error{};  // per bin; NaN when it cannot be told
  std::vector<bool> reliable{};          // per bin: enough effective samples and groups
  double degrees_of_freedom = 0;         // of the t-intervals around every bin
  std::map<int, std::vector<double>>
      by_length{};  // number of vertices -> film of those paths alone
};

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

struct Rendering {
  bool complete = true;
  std::string method{};
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;
  int threads = 1;
  double seconds = 0;            // wall time, from the building of the scene to the last number
  double processor_seconds = 0;  // of all threads in that time
  double seed_seconds = 0;       // wall time until the end of the seed pass
  std::string precision = "double";
  FilmEstimate film;
  std::optional<Normalization> normalization{};
  int chains = 0, groups = 0;                   // Markov chain methods only
  std::optional<ChainsRecord> chains_record{};  // Markov chain methods only
  std::vector<MutationRecord> mutations{};      // Markov chain methods only
  std::vector<std::string> warnings{};
};

}  // namespace wander
