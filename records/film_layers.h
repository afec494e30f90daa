// What is known of every bin or pixel of a film, as named layers: what the files that hold films
// have in common.
//
//   value, standard_error, reliable (1 or 0)    the estimate
//   vertices_N                                  its part from paths of N vertices
//   chains, chains.standard_error               if it is pooled: of the chains alone
//   samples                                     if it is pooled: what of the value samples carry
//   acceptance.MUTATION, proposed.MUTATION      Markov chain methods; of a large film, if at all,
//                                               from the cells of those maps (core/film_layout.h)
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image_shape.h"
#include "records/rendering.h"

namespace wander {

// The names of so many channels: Y, or R, G and B.
std::span<const std::string_view> channel_names(std::size_t channels);
// What mutations did is of a pixel, and all else of its channels.
std::size_t channels_of(std::string_view layer, std::size_t film_channels);

// Numbers that are asked for one by one, at pixel · channels + channel; they are those of the
// rendering, which must stay.
struct FilmLayer {
  std::string name;
  std::size_t channels;
  std::function<double(std::size_t)> number;
};
// Throws std::logic_error if one does not fit the shape of the film.
std::vector<FilmLayer> layers_of(const Rendering& rendering);

// The way back: takes the number at an index.
struct FilmLayerSlot {
  std::string name;
  std::size_t channels;
  std::function<void(std::size_t, double)> put;
};
// Room for the layers of these names in a rendering whose film has its shape.  Names that mean
// nothing have no slot.  Throws std::runtime_error if the estimate is not among them.
std::vector<FilmLayerSlot> slots_of(Rendering& rendering, const std::set<std::string>& names);
// When all numbers are there: what follows from them for the mutations as a whole.
void sum_up_mutations(Rendering& rendering);

}  // namespace wander
