// The film: what samples deposit, and the estimate with its error bars that comes of it.
//
// Two kinds of observations make a film.  Independent samples give their own variance (SampleFilm);
// Markov chains come in independent groups, and the spread of the groups is the error (GroupFilm).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/film_estimate.h"
#include "statistics/sum.h"

namespace wander {

// A bin is reliable when at least this many effective samples, (Σ x)² / Σ x² [Kish 1965], reached
// it: then no few samples dominate it, and its t-interval holds what it promises.
inline constexpr double fewest_effective_samples = 100;

// What a bin has not seen is no part of its error bar.  Techniques (n, s) that are seen less than
// this often per bin, in effective samples, are rare; they may not carry more than this many
// standard errors of a bin, or else the bin is not reliable.
inline constexpr double fewest_technique_samples = 5;
inline constexpr double most_rare_light = 0.5;

// Films by path length are kept up to this many numbers.
inline constexpr std::int64_t most_length_values = std::int64_t{1} << 24;

// Films of paths of each length, made as the lengths occur.
class LengthFilms {
 public:
  LengthFilms(int bins, int max_vertices);

  void add(int vertices, int bin, double value) {
    if (films_.empty()) return;
    auto& film = films_[static_cast<std::size_t>(vertices - 2)];
    if (film.empty()) film.resize(static_cast<std::size_t>(bins_));
    film[static_cast<std::size_t>(bin)] += value;
  }
  void merge(const LengthFilms& other);
  void clear();
  std::map<int, std::vector<double>> scaled(double factor) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bins_, films_);
  }

 private:
  int bins_;
  std::vector<std::vector<Sum>> films_;  // by number of vertices - 2; empty until one contributes
};

// Film-wide sums of contributions by technique (n, s).
class TechniqueTally {
 public:
  explicit TechniqueTally(int max_vertices);

  void add(int vertices, int technique, double contribution);
  void merge(const TechniqueTally& other);
  void clear();
  // Σ of the contributions of all techniques that have fewer effective samples than this.
  double rare_light(double effective_samples) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(longest_, sums_);
  }

 private:
  struct Sums {
    double sum = 0, squares = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(sum, squares);
    }
  };
  int longest_;  // longer paths share the last entry
  std::vector<Sums> sums_;
};

// Contributions of independent samples, per bin: Σ x and Σ x² over samples.
class SampleFilm {
 public:
  SampleFilm(int bins, int max_vertices);

  // To the sample that is under way: a path of `vertices`, by technique s = `technique`.
  void add(int vertices, int technique, int bin, double contribution);
  void end_sample();
  void merge(const SampleFilm& other);
  void clear();

  std::uint64_t samples() const { return samples_; }
  FilmEstimate estimate(std::span<const int> resolution) const;

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
