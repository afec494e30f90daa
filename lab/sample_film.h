// The loop that all estimators by independent samples share: samples in units, units in parallel,
// their films merged in order, until the budget is spent.
#pragma once

#include <functional>
#include <span>

#include "core/film.h"
#include "core/rng.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

// Adds one sample, made of the numbers of `rng`, to the film.
using FilmSampler = std::function<void(Rng& rng, SampleFilm& film)>;

// Every unit that works at the same time has a sampler of its own, made by `make`.
Rendering sample_film(const char* method, std::span<const int> shape, int max_vertices,
                      const Session& session, const std::function<FilmSampler()>& make);

}  // namespace wander
