// How a film is kept in memory while samples or chains fill it: the one place that says which films
// are large.
//
//                        up to `most_small` bins          large, or in colour
//   pixels of chains     one film for each group          few, shared by groups (shared_films.h)
//   pixels of samples    a film for each unit under way   lists of what units found
//   what normalization
//     needs per place    the film itself                  a raster of at most `most_small` cells
//   acceptance maps      the film itself                  if asked for, that raster
//   films by length      up to 2^24 numbers               if asked for
#pragma once

#include <cstdint>

#include "core/raster.h"
#include "core/tint.h"

namespace wander {

// Films by path length come by themselves up to this many numbers.
inline constexpr std::int64_t most_length_values = std::int64_t{1} << 24;

enum class Keep { where_small, always };

struct FilmLayout {
  std::size_t most_small = std::size_t{1} << 14;
  Keep by_length = Keep::where_small;
  Keep maps = Keep::where_small;

  bool operator==(const FilmLayout&) const = default;

  // Of the shape of a film.
  Raster raster(std::span<const int> film) const { return {pixels_of(film), most_small}; }
  bool is_large(std::span<const int> film) const {
    return !raster(film).is_film() || channels_of(film) > 1;
  }
  // Are films of paths of each length kept?
  bool keeps_lengths(std::span<const int> film, int max_vertices) const {
    if (by_length == Keep::always) return true;
    std::int64_t numbers = max_vertices - 1;
    for (const int extent : film) numbers *= extent;
    return raster(film).is_film() && numbers <= most_length_values;
  }
  // Where acceptance is told apart; no cells if it is not.
  Raster maps_of(std::span<const int> film) const {
    const Raster cells = raster(film);
    return maps == Keep::always || cells.is_film() ? cells : Raster(0);
  }
};

}  // namespace wander
