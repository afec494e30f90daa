// Doubts about a film of independent samples, each with its remedy, where what was seen is no evidence of what was
// not (core/film.h).
#pragma once

#include <cstdint>
#include <string>

#include "core/film.h"
#include "records/rendering.h"

namespace wander {

// Of light that comes by mirrors or smooth glass, if there are any: do techniques find it that connect
// vertices before and behind them, or only a subpath that meets a lamp by chance?
enum class LightByMirrors { connected, by_chance };

// Why few bins are called reliable, where it is for light that techniques seldom find.  Empty where most lit
// bins have no such doubt.
std::string rare_techniques(const TechniqueTally& techniques, const FilmEstimate& film,
                            std::uint64_t samples);

// What there is to say against a film; of which no bin is reliable if lamps that light needs to be met by chance
// hardly ever were.
void add_doubts(Rendering& rendering, const TechniqueTally& techniques, LightByMirrors mirrors);

}  // namespace wander
