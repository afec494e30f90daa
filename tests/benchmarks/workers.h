// What is measured: samples and mutations as the renderers make them, up to the film.
#pragma once

#include "core/bins_of_sample.h"
#include "core/large_sample_film.h"
#include "mlt/run/deposit.h"
#include "mlt/run/group_films.h"
#include "mlt/seeds/seed_pass.h"
#include "mlt/watch/functionals.h"
#include "mlt/watch/statistics.h"
#include "mutations/catalogue.h"

namespace wander {

// Bidirectional samples, as lab/estimate.cpp makes them.  Each worker has a range of samples.
template <World W>
class SampleWorker {
 public:
  static constexpr int items_per_turn = 64;

  SampleWorker(const Transport<W>& transport, std::uint64_t first)
      : transport_(transport),
        bins_(transport_),
        sampler_(transport, all_techniques, Heuristic::power),
        film_(transport.scene().film_shape(), transport.max_vertices(), {}),
        part_(transport.scene().film_shape(), transport.max_vertices(), {}),
        random_(1, Purpose::estimate, 0),
        next_(first) {}

  void take_turn() {
    for (int i = 0; i < items_per_turn; ++i) {
      random_.start(next_++);
      found_.clear();
      bins_.begin();
      sampler_.sample(random_, [&](const JoinedPath<W>& path, int s, double weighted) {
        found_.push_back({path.size(), s, bins_(path, s), weighted});
        if constexpr (W::channels > 1) found_.back().tint = path.colour().colour;
      });
      part_.add(found_);
    }
    if constexpr (W::dimension == 3) {
      film_.merge(part_);
      part_.clear();
    }
  }

 private:
  using Film = std::conditional_t<W::dimension == 3, LargeSampleFilm, SampleFilm>;

  Transport<W> transport_;
  BinsOfSample<Transport<W>> bins_;
  PathSampler<Transport<W>> sampler_;
  Film film_;
  typename Film::Part part_;
  Contributions found_;
  Rng random_;
  std::uint64_t next_;
};

// Samples of the slice of one group, with all that they are evidence of, for a pooled film.
template <World W>
class SeedWorker {
 public:
  static constexpr int items_per_turn = 64;

  SeedWorker(const Transport<W>& transport, int group)
      : slice_(transport, 1, group, seeds),
        parts_({.partition = {.c = 100}}, transport.scene().film_shape(), transport.max_vertices(),
               {}),
        film_(transport.scene().film_shape(), transport.max_vertices(), {}) {}

  void take_turn() {
    slice_.run(items_per_turn, SampleWatcher<W, Ratios::of_paths>(parts_));
    if constexpr (W::dimension == 3) parts_.move_samples_to(film_);
  }

 private:
  static constexpr int seeds = 64;

  SeedSlice<Transport<W>> slice_;
  PooledParts parts_;
  LargeSampleFilm film_;
};

// Mutations of one chain, as lab/render.h makes them.
template <World W>
class ChainWorker {
 public:
  static constexpr int items_per_turn = 128;

  ChainWorker(const Transport<W>& transport, const Family& family, const Path<W>& seed,
              std::uint32_t stream)
      : transport_(transport),
        chain_(transport_, family, seed),
        film_(transport.scene().film_shape(), transport.max_vertices(), {}),
        pixels_(values_of(transport.scene().film_shape()), 0),
        statistics_(Family::names, FilmLayout{}.maps_of(transport.scene().resolution()),
                    transport.max_vertices()),
        random_(1, Purpose::chain, stream),
        current_(features(transport, seed)),
        runs_(Family::count) {}

  void take_turn() {
    if (FilmLayout{}.is_large(transport_.scene().film_shape())) film_.share(pixels_, 1);
    for (int i = 0; i < items_per_turn; ++i) {
      random_.start(steps_);
      statistics_.timed(steps_++, [&] {
        int mutation = 0;
        chain_.step(random_, [&](const Step<W>& step) {
          for_each_deposit(transport_, step, current_.bin,
                           [this](const auto&, int vertices, int bin, double weight,
                                  const auto& tint) { film_.add(vertices, bin, weight, tint); });
          statistics_.observe(observation(transport_, step, current_), runs_);
          if (step.accepted()) current_ = features(transport_, step.proposed);
          mutation = step.mutation;
        });
        return mutation;
      });
      draws_.offer([&] { return functionals(transport_, chain_.current()); });
    }
  }

  const GroupFilm& film() const { return film_; }
  const MutationStatistics& statistics() const { return statistics_; }

 private:
  const Transport<W>& transport_;
  Chain<Transport<W>, Family> chain_;
  GroupFilm film_;
  SharedFilm pixels_;
  MutationStatistics statistics_;
  Rng random_;
  Features current_;
  RejectionRuns runs_;
  ThinnedDraws draws_;
  std::uint64_t steps_ = 0;
};

}  // namespace wander
