// The run that all estimators by independent samples share: samples in units, units in parallel,
// their films merged in order.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "core/film.h"
#include "core/rng.h"
#include "lab/live_run.h"
#include "lab/sample_doubts.h"
#include "work/parallel.h"

namespace wander {

// Makes one sample of the numbers of `rng`; `found` is empty before.
using FilmSampler = std::function<void(Rng& rng, Contributions& found)>;

// Who samples, and what it must meet by chance to see all light.
struct SamplingMethod {
  SamplingMethod(const char* name, FoundByChance by_chance = {})
      : name(name), by_chance(by_chance) {}

  const char* name;
  FoundByChance by_chance;
};

// Every unit that works at the same time has a sampler of its own, made by `make`.
std::unique_ptr<LiveRun> make_sample_run(const SamplingMethod& method, std::span<const int> shape,
                                         int max_vertices, const FilmLayout& layout,
                                         const Run& execution,
                                         const std::function<FilmSampler()>& make);

// Such a run, to the end of the session's budget.
Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make);

}  // namespace wander
