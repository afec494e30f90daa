// The pixels of a large film that chains fill: few films, each shared by every so many of the
// groups, in float, and what all of them have in common in double.
//
//   deposits on bin j in film f = common_j + own_fj
//
// A bin is one channel of a pixel.  A group adds to own_fj in float.  A tile of bins in which a film has taken `most_additions` is
// flushed between two turns of the groups: the mean of own_fj over f moves to common_j, in double.
// What stays in float is how far the films differ.
//
// Error.  An addition is rounded up or down by chance, in proportion to what is nearer, so that its
// mean is right however small it is: nothing is ever lost beside a large number.  Its standard
// deviation is at most 2^-24 of what the float holds, which is the deposits since the last flush,
// most_additions and those of one turn at the most, and the difference of the films, which is their
// noise.  After n additions on a bin it is √n 2^-24 of that noise: for n = 2^36, a sixtieth.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "core/film_layout.h"

namespace wander {

// One of the films.  One thread at a time.
class SharedFilm {
 public:
  static constexpr std::size_t tile = 256;  // bins
  static constexpr std::uint32_t most_additions = 1 << 12;

  SharedFilm(std::size_t bins, int lengths)
      : own_(bins),
        lengths_(static_cast<std::size_t>(lengths)),
        additions_((bins - 1) / tile + 1) {}

  // To all channels of a pixel.
  template <int Channels>
  void add(int vertices, int pixel, double weight, const Tint<Channels>& colour) {
    for (int k = 0; k < Channels; ++k) add(vertices, pixel * Channels + k, weight * colour[k]);
  }
  void add(int vertices, int bin, double weight) {
    const auto j = static_cast<std::size_t>(bin);
    add(own_[j], weight);
    if (!lengths_.empty()) add(of_length(vertices)[j], weight);
    if (++additions_[j / tile] == most_additions) full_.push_back(j / tile);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(own_, lengths_, additions_, chance_);
  }

 private:
  friend class SharedFilms;

  // The 29 bits of the sum that a float does not have are rounded with a probability: they carry if
  // a number that goes through all values evenly [Weyl 1916] is added.
  void add(float& sum, double weight) {
    constexpr std::uint64_t lost = (std::uint64_t{1} << 29) - 1;
    chance_ += 0x9E3779B97F4A7C15;  // φ - 1, as a fraction of 2^64
    const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(sum) + weight);
    sum = static_cast<float>(std::bit_cast<double>((bits + (chance_ >> 35)) & ~lost));
  }
  std::vector<float>& of_length(int vertices) {
    auto& film = lengths_[static_cast<std::size_t>(vertices) - 2];
    if (film.empty()) film.resize(own_.size());
    return film;
  }

  std::vector<float> own_;
  std::vector<std::vector<float>> lengths_;  // by vertices - 2; empty until one is met
  std::vector<std::uint32_t> additions_;     // by tile, since it was flushed
  std::vector<std::size_t> full_;            // tiles that are to be flushed
  std::uint64_t chance_ = 0;
};

class SharedFilms {
 public:
  // As few as give error bars that are trusted (deposit.h); of an image of few pixels, one for each
  // group.
  static int films_of(std::span<const int> film, int groups, const FilmLayout& layout) {
    return layout.has_few_pixels(film) ? groups : std::min(groups, 16);
  }
  // The groups that share a film take turns of so many steps each, for otherwise a tile could take
  // any number of additions before it is flushed.
  static constexpr std::uint64_t steps_per_turn = 256;

  SharedFilms(std::span<const int> film, int max_vertices, int groups, const FilmLayout& layout);

  int count() const { return static_cast<int>(films_.size()); }
  int groups() const { return groups_; }
  int film_of_group(int group) const { return group % count(); }
  // What a group's deposits have to be multiplied by, so that all films hold the sum of as many
  // groups: films_of_all / groups_of_all over one / groups of its film.
  double share_of_group(int group) const;
  SharedFilm& operator[](int film) { return films_[static_cast<std::size_t>(film)]; }

  // Between two turns.
  void flush();

  std::size_t bins() const { return common_.size(); }
  double deposits(std::size_t film, std::size_t bin) const {
    return common_[bin] + static_cast<double>(films_[film].own_[bin]);
  }
  std::size_t lengths() const { return lengths_.size(); }
  // The mean of all films, of paths of `length` + 2 vertices; empty if there are none.
  std::vector<double> mean_of_length(std::size_t length) const;

  template <class Archive>
  void serialize(Archive& archive) {
    for (SharedFilm& film : films_) archive(film);
    archive(common_, lengths_);
  }

 private:
  void flush(std::size_t tile);

  int groups_;
  std::vector<SharedFilm> films_;
  std::vector<double> common_;
  std::vector<std::vector<double>> lengths_;  // Σ over films, by vertices - 2; empty until flushed
};

}  // namespace wander
