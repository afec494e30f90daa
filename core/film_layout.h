// How a film is kept in memory while samples or chains fill it: the one place that says which films
// are large.
//
//                        up to `most_small` bins          large, or in colour (of few pixels, (*) by itself)
//   pixels of chains     one film for each group          few, shared by groups (shared_films.h)
//   pixels of samples    a film for each unit under way   lists of what units found
//   what normalization
//     needs per place    the film itself                  a raster of at most `most_cells`
//   acceptance maps      the film itself                  if asked for (*), a raster of at most `most_small`
//   films by length      up to 2^24 numbers               if asked for (*)
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/raster.h"
#include "core/tint.h"

namespace wander {

// Films by path length come by themselves up to this many numbers.
inline constexpr std::int64_t most_length_values = std::int64_t{1} << 24;

enum class Keep { where_small, always };

struct FilmLayout {
  std::size_t most_small = std::size_t{1} << 14;
  // Every group has a raster, and goes through it at every sample: all of them together stay in the cache.
  std::size_t most_cells = std::size_t{1} << 10;
  Keep by_length = Keep::where_small;
  Keep maps = Keep::where_small;

  bool operator==(const FilmLayout&) const = default;

  // Of the shape of a film, whose last axis is of its channels if there are several.
  bool has_few_pixels(std::span<const int> film) const { return pixels(film).is_film(); }
  bool is_large(std::span<const int> film) const {
    return !has_few_pixels(film) || channels_of(film) > 1;
  }
  Raster raster(std::span<const int> film) const {
    if (!is_large(film)) return pixels(film);
    return {pixels_of(film), std::min(most_small, most_cells)};
  }
  // Are films of paths of each length kept?
  bool keeps_lengths(std::span<const int> film, int max_vertices) const {
    if (by_length == Keep::always) return true;
    std::int64_t numbers = max_vertices - 1;
    for (const int extent : film) numbers *= extent;
    return has_few_pixels(film) && numbers <= most_length_values;
  }
  // Where acceptance is told apart; no cells if it is not.
  Raster maps_of(std::span<const int> film) const {
    return maps == Keep::always || has_few_pixels(film) ? pixels(film) : Raster(0);
  }

 private:
  Raster pixels(std::span<const int> film) const { return {pixels_of(film), most_small}; }
};

}  // namespace wander
