// Techniques of samples that are seldom seen (core/film.h), in the words of warnings.
#pragma once

#include <cstdint>
#include <string>

#include "core/film.h"

namespace wander {

// Those with most of their light, and its share of the film.
struct SeldomSeen {
  std::string names, share;
};
SeldomSeen seldom_seen(const TechniqueTally& techniques, const FilmEstimate& film,
                       std::uint64_t samples);

}  // namespace wander
