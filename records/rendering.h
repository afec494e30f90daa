// What a run computed: the film with its error bars, and for Markov chain methods the normalization
// and the record of each mutation.  Plain data, made by the estimators and read by the writers of
// EXR, CSV and JSON and by the figures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/adaptation.h"
#include "mlt/run/normalization_record.h"
#include "mlt/run/partition.h"
#include "mlt/watch/chains_record.h"

namespace wander {

// One of several runs that were merged.
struct MergedRun {
  std::uint64_t seed = 1, samples = 0;
  double seconds = 0;
  bool complete = true;
};

// A class of path: its share of all light, and what of its light samples carry (mlt/run/class_parts.h).
struct ClassRecord {
  std::string path_class;
  double light = 0, of_samples = 0;
};

// How a film was pooled of samples and chains (mlt/run/partition.h).
struct PoolingRecord {
  Pooling how{};                          // of several runs, of the first
  std::uint64_t samples = 0;              // of the seed pass and beside the chains; 0: not known
  double light_of_samples = 0;            // the share of the light that they carry
  std::vector<double> film_of_samples{};  // what of each number of the film they carry
  std::vector<ClassRecord> classes{};     // the brightest first; empty where states have no class
};

struct Rendering {
  bool complete = true;
  std::string method{};
  std::uint64_t samples = 0;
  std::uint64_t seed = 1;
  std::vector<MergedRun> merged{};  // if it is of several runs: `seed` is that of the first
  int threads = 1;
  // Wall time, from the building of the scene to the last number; the sum of those of merged runs.
  double seconds = 0;
  double processor_seconds = 0;  // of all threads in that time
  double seed_seconds = 0;       // wall time until the end of the seed pass
  std::string precision = "double";
  int max_vertices = 0;  // of its paths, both ends counted; 0: that is not known
  FilmEstimate film;
  std::optional<Adaptation> adaptation{};  // if the kernel is; of several runs, of the first
  std::optional<PoolingRecord> pooling{};  // if the film is pooled
  std::optional<FilmEstimate>
      chains_film{};  // then: of the chains alone; of a large one, no errors
  std::optional<Normalization> normalization{};
  int chains = 0, groups = 0;                   // Markov chain methods only
  std::optional<ChainsRecord> chains_record{};  // Markov chain methods only
  std::vector<MutationRecord> mutations{};      // Markov chain methods only
  std::vector<std::string> warnings{};
};

}  // namespace wander
