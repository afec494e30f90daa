// The film: what samples deposit, and the estimate with its error bars that comes of it.
//
// Two kinds of observations make a film.  Independent samples give their own variance (SampleFilm,
// and LargeSampleFilm where there are many bins); Markov chains come in independent groups, and the
// spread of the groups is the error (mlt/run/deposit.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "core/film_estimate.h"
#include "core/film_layout.h"
#include "statistics/sum.h"

namespace wander {

// What a bin has not seen is no part of its error bar, nor of those around it where they have not seen it either.
// Techniques (n, s) that are seen less than this often in a neighbourhood (core/reliability.h), in effective samples and in the
// mean over a film, are rare: as many of them, those of the brightest paths first, as all together are.  They may not
// carry more than this many standard errors of a bin, or else the bin is not reliable.
inline constexpr double fewest_in_neighbourhood = 22.5;
inline constexpr double most_rare_light = 0.5;

// Of a technique on a whole film of this shape, whose neighbourhoods these are: below, it may be rare.
double fewest_on_film(std::span<const int> shape);

// Room for so many bins as the shape of a film says, of which nothing is known yet; returns how many.
std::size_t make_room(FilmEstimate& film);

// Films of paths of each length, made as the lengths occur.
class LengthFilms {
 public:
  // Keeps none if there are to be none.
  LengthFilms(int bins, int lengths) : bins_(bins), films_(static_cast<std::size_t>(lengths)) {}

  void add(int vertices, int bin, double value) {
    if (films_.empty()) return;
    auto& film = films_[static_cast<std::size_t>(vertices - 2)];
    if (film.empty()) film.resize(static_cast<std::size_t>(bins_));
    film[static_cast<std::size_t>(bin)] += value;
  }
  bool keeps_any() const { return !films_.empty(); }
  void merge(const LengthFilms& other);
  void clear();
  // Over all lengths, by bin.
  std::vector<double> by_bin() const;
  // Over the whole film, by number of vertices - 2.
  std::vector<double> by_length() const;
  std::map<int, std::vector<double>> scaled(double factor) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bins_, films_);
  }

 private:
  int bins_;
  std::vector<std::vector<Sum>> films_;  // by number of vertices - 2; empty until one contributes
};

// What a technique (n, s) brought to the film, if it was seen seldom.
struct RareTechnique {
  int vertices, technique;
  double light;  // Σ of its contributions
};

// Σ x and Σ x² over samples.
struct BinSums {
  double sum = 0, squares = 0;

  void add(double x) {
    sum += x;
    squares += x * x;
  }
  void merge(const BinSums& other) {
    sum += other.sum;
    squares += other.squares;
  }
  // (Σ x)² / Σ x² [Kish 1965].
  double effective_samples() const { return squares > 0 ? sum * sum / squares : 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sum, squares);
  }
};

// Film-wide sums of contributions by technique (n, s).
class TechniqueTally {
 public:
  explicit TechniqueTally(int max_vertices);

  void add(int vertices, int technique, double contribution);
  void merge(const TechniqueTally& other);
  void clear();
  // Techniques that have fewer effective samples than this, and have fewer all together: those of the brightest
  // paths, in the mean Σ x² / Σ x.  The one with most light first.
  std::vector<RareTechnique> rare(double effective_samples) const;
  // Σ of their contributions.
  double rare_light(double effective_samples) const;
  // Of paths of three vertices and more: of sensor subpaths that met a light by chance, s = 0, and of light subpaths that met
  // the sensor, s = n.
  BinSums lights_met() const;
  BinSums sensors_met() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(longest_, sums_);
  }

 private:
  std::size_t index(int vertices, int technique) const {
    return static_cast<std::size_t>(std::min(vertices, longest_) * (longest_ + 1) +
                                    std::min(technique, longest_));
  }

  int longest_;  // longer paths share the last entry
  std::vector<BinSums> sums_;
};

// Bins of which techniques that were seen seldom do not carry too much.
std::vector<bool> without_rare_light(const FilmEstimate& film, const TechniqueTally& techniques,
                                     std::uint64_t samples);

// The film, but for its parts by length.
FilmEstimate estimate_of_samples(std::span<const int> shape, std::uint64_t samples,
                                 const TechniqueTally& techniques,
                                 const std::function<BinSums(std::size_t bin)>& sums);

// What a sample found: a path of `vertices`, by technique s = `technique`.  `value` is luminance.
struct Contribution {
  int vertices, technique, bin;
  double value;
  std::array<double, 3> tint{1, 1, 1};  // counts on films in colour alone
};
using Contributions = std::vector<Contribution>;

// Contributions of independent samples, per bin: Σ x and Σ x² over samples.  In one channel.
class SampleFilm {
 public:
  // Filled on its own and then merged.
  using Part = SampleFilm;

  SampleFilm(int bins, int max_vertices, const FilmLayout& layout = {});
  // Of this shape.
  SampleFilm(std::span<const int> shape, int max_vertices, const FilmLayout& layout)
      : SampleFilm(static_cast<int>(values_of(shape)), max_vertices, layout) {}

  // To the sample that is under way.
  void add(int vertices, int technique, int bin, double contribution);
  void end_sample();
  // A whole sample.
  void add(const Contributions& sample);
  void merge(const SampleFilm& other);
  void clear();

  std::uint64_t samples() const { return samples_; }
  const TechniqueTally& techniques() const { return techniques_; }
  FilmEstimate estimate(std::span<const int> shape) const;

  // Between two samples.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(sum_, squares_, lengths_, techniques_, samples_);
  }

 private:
  std::vector<Sum> sum_, squares_;
  std::vector<double> current_;  // of the sample under way; zero outside `touched_`
  std::vector<int> touched_;
  LengthFilms lengths_;
  TechniqueTally techniques_;
  std::uint64_t samples_ = 0;
};

}  // namespace wander
