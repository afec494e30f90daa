// Monte Carlo estimation of the film by independent samples of paths: path tracing, light tracing
// and bidirectional path tracing are the same estimator with different techniques.
#pragma once

#include <memory>

#include "core/film_layout.h"
#include "core/path_sampler.h"
#include "lab/sample_doubts.h"
#include "lab/stage.h"

namespace wander {

struct Estimator {
  const char* name;  // of the method
  TechniqueSet techniques;
  Roulette roulette;
  Heuristic heuristic;
  MetByChance must_meet = MetByChance::nowhere;
};

inline constexpr Estimator path_tracing{"pt",
                                        {.most_light = 1, .fewest_sensor = 1},
                                        Roulette::by_albedo,
                                        Heuristic::power,
                                        MetByChance::lights};
inline constexpr Estimator light_tracing{"lt",
                                         {.fewest_light = 1, .most_sensor = 1},
                                         Roulette::by_albedo,
                                         Heuristic::power,
                                         MetByChance::sensors};
// [Lafortune and Willems 1993; Veach and Guibas 1995].
inline constexpr Estimator bidirectional_path_tracing{"bdpt", all_techniques, Roulette::by_albedo,
                                                      Heuristic::power, MetByChance::either};
// Without connections, so that light by mirrors is no rarer than other light [Kajiya 1986; Arvo and Kirk 1990].
inline constexpr Estimator naive_path_tracing{
    "pt-naive", {.most_light = 0}, Roulette::off, Heuristic::balance};
inline constexpr Estimator naive_light_tracing{
    "lt-naive", {.most_sensor = 0}, Roulette::off, Heuristic::balance};

// Those of the table of methods.
std::span<const Estimator> estimators();

// A method whose estimator is one of these.
struct IndependentSamples {
  template <World W>
  static std::unique_ptr<LiveRun> make(const Stage<W>& stage);
};

template <World W>
std::unique_ptr<LiveRun> make_estimate(const Scene<W>& scene, const Estimator& estimator,
                                       const FilmLayout& layout, const Run& execution);

// Such a run, to the end of the session's budget.
template <World W>
Rendering estimate(const Scene<W>& scene, const Estimator& estimator, const Session& session);

}  // namespace wander
