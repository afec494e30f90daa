// What is measured: samples and mutations as the renderers make them, up to the film.
#pragma once

#include "core/film.h"
#include "mlt/run/deposit.h"
#include "mlt/seeds/seed_pass.h"
#include "mlt/watch/functionals.h"
#include "mlt/watch/statistics.h"
#include "mutations/catalogue.h"

namespace wander {

using Light = Transport<Flatland>;

// Bidirectional samples, as lab/estimate.cpp makes them.  Each worker has a range of samples.
class SampleWorker {
 public:
  static constexpr int items_per_turn = 64;

  SampleWorker(const Light& transport, std::uint64_t first)
      : transport_(transport),
        sampler_(transport, all_techniques, Heuristic::power),
        film_(transport.scene().bins(), transport.max_vertices()),
        random_(1, Purpose::estimate, 0),
        next_(first) {}

  void take_turn() {
    for (int i = 0; i < items_per_turn; ++i) {
      random_.start(next_++);
      sampler_.sample(random_, [&](const Path<Flatland>& path, int s, double weighted) {
        film_.add(path.size(), s, transport_.bin(path), weighted);
      });
      film_.end_sample();
    }
  }

 private:
  Light transport_;
  PathSampler<Light> sampler_;
  SampleFilm film_;
  Rng random_;
  std::uint64_t next_;
};

// Mutations of one chain, as lab/render.h makes them.
class ChainWorker {
 public:
  static constexpr int items_per_turn = 128;

  ChainWorker(const Light& transport, const Family& family, const Path<Flatland>& seed,
              std::uint32_t stream)
      : transport_(transport),
        chain_(transport_, family, seed),
        film_(transport.scene().bins(), transport.max_vertices()),
        statistics_(Family::names, transport.scene().bins(), transport.max_vertices()),
        random_(1, Purpose::chain, stream),
        current_(features(transport, seed)),
        runs_(Family::count) {}

  void take_turn() {
    for (int i = 0; i < items_per_turn; ++i) {
      random_.start(steps_);
      statistics_.timed(steps_++, [&] {
        int mutation = 0;
        chain_.step(random_, [&](const Step<Flatland>& step) {
          deposit(transport_, step, current_.bin, film_);
          statistics_.observe(observation(transport_, step, current_), runs_);
          if (step.accepted()) current_ = features(transport_, step.proposed);
          mutation = step.mutation;
        });
        return mutation;
      });
      draws_.offer([&] { return functionals(transport_, chain_.current()); });
    }
  }

 private:
  const Light& transport_;
  Chain<Light, Family> chain_;
  GroupFilm film_;
  MutationStatistics statistics_;
  Rng random_;
  Features current_;
  RejectionRuns runs_;
  ThinnedDraws draws_;
  std::uint64_t steps_ = 0;
};

}  // namespace wander
