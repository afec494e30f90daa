// Monte Carlo estimation of the film by independent samples of paths: path tracing, light tracing
// and bidirectional path tracing are the same estimator with different techniques.
#pragma once

#include <memory>

#include "core/film_layout.h"
#include "core/path_sampler.h"
#include "lab/live_run.h"
#include "lab/method.h"
#include "work/parallel.h"

namespace wander {

struct Estimator {
  const char* name;
  TechniqueSet techniques;
  Roulette roulette;
  Heuristic heuristic;
};

// pt, lt, bdpt, and the forms of Kajiya 1986 and Arvo 1990 without connections, pt-naive, lt-naive.
std::span<const Estimator> estimators();
// Of a method by independent samples.
const Estimator& estimator_of(const Method& method);

template <World W>
std::unique_ptr<LiveRun> make_estimate(const Scene<W>& scene, const Estimator& estimator,
                                       const FilmLayout& layout, const Run& execution);

// Such a run, to the end of the session's budget.
template <World W>
Rendering estimate(const Scene<W>& scene, const Estimator& estimator, const Session& session);

}  // namespace wander
