// What a run of chains decides by its pilot, before its first sample: how its film is shared out between samples and
// chains (mlt/run/partition.h), how long its seed pass is, and how many chains there are.
#pragma once

#include <cstddef>
#include <optional>

#include "mlt/run/chain_settings.h"
#include "mlt/run/pilot.h"
#include "work/parallel.h"

namespace wander {

struct PoolingPlan {
  Pooling pooling;
  ChainSettings settings;  // of the run, with as many chains and seeds as the pilot says
  double seed_share;       // of the seed pass before the chains
};

// What is planned for.
struct PlannedFilm {
  FilmKind kind;
  std::size_t bins;  // in all channels
  int max_vertices;  // of its paths
};

class PoolingPlanner {
 public:
  // `settings`: as the run was asked for.
  PoolingPlanner(const Run& run, const ChainSettings& settings, const PlannedFilm& film)
      : run_(run), settings_(settings), film_(film) {}

  // Where samples alone decide; or else chains have to be asked.  Of an image they always are: what few samples have not
  // seen may be as bright as a pixel is.
  std::optional<PoolingPlan> by_samples(Pilot samples) const;
  PoolingPlan by_chains(Pilot pilot) const;
  // Are chains left nothing but what is hardly known, of an image?  Then more steps of a pilot seldom change it.
  bool leaves_to_samples(const Pilot& pilot) const;

  // As far as it is known before the run.
  double steps_per_chain() const;

 private:
  double steps() const;
  double seeds_per_step() const;
  double most_cost() const;
  bool is_of_time() const;
  bool is_of_error() const;
  bool has_all_samples_before() const;
  ChainSettings settings_of_chains(const Pilot& pilot, double samples_per_step) const;
  double seed_share(const Pilot& pilot, const Pooling& pooling) const;
  double seed_share_in_the_dark(const Pilot& pilot) const;
  PoolingPlan plan(const Pilot& pilot, const Pooling& pooling) const;
  Pooling with_seed_share(Pilot pilot, double share) const;
  std::uint64_t seeds_for(const Pilot& pilot) const;

  const Run& run_;
  const ChainSettings& settings_;
  PlannedFilm film_;
};

}  // namespace wander
