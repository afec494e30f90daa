// The film of independent samples where there are many bins, or colours: one film of plain sums, to which the
// lists of what units of samples found are added in order.  A unit under way so costs memory by what
// it found, not by the bins.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/film.h"

namespace wander {

// What some samples found, in their order.
class SampleList {
 public:
  // A film in one dimension.
  SampleList(int bins, int max_vertices, const FilmLayout& layout)
      : SampleList(std::array{bins}, max_vertices, layout) {}
  SampleList(std::span<const int> shape, int max_vertices, const FilmLayout& layout);

  void add(const Contributions& sample);
  void clear();
  std::uint64_t samples() const { return samples_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(bins_, lengths_, techniques_, samples_);
  }

 private:
  friend class LargeSampleFilm;

  struct OfBin {
    int bin = 0;
    double value = 0;  // of one sample

    template <class Archive>
    void serialize(Archive& archive) {
      archive(bin, value);
    }
  };
  struct OfLength {
    int vertices = 0, bin = 0;
    double value = 0;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(vertices, bin, value);
    }
  };
  // Where the bins of a pixel are among what was found, of the sample that begins there.
  OfBin* channels_of_pixel(int pixel, std::size_t begin);

  bool keeps_lengths_;
  int channels_;
  std::vector<OfBin> bins_;
  std::vector<OfLength> lengths_;
  TechniqueTally techniques_;
  std::uint64_t samples_ = 0;
};

class LargeSampleFilm {
 public:
  using Part = SampleList;

  // A film in one dimension.
  LargeSampleFilm(int bins, int max_vertices, const FilmLayout& layout)
      : LargeSampleFilm(std::array{bins}, max_vertices, layout) {}
  LargeSampleFilm(std::span<const int> shape, int max_vertices, const FilmLayout& layout);

  void merge(const SampleList& part);
  void merge(const LargeSampleFilm& other);

  std::uint64_t samples() const { return samples_; }
  const TechniqueTally& techniques() const { return techniques_; }
  BinSums sums(std::size_t bin) const { return sums_[bin]; }
  FilmEstimate estimate(std::span<const int> shape) const;
  // Films of paths of each length.
  std::map<int, std::vector<double>> by_length(std::span<const int> shape) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sums_, lengths_, techniques_, samples_);
  }

 private:
  std::vector<BinSums> sums_;                 // side by side, for they are met together
  std::vector<std::vector<double>> lengths_;  // by number of vertices - 2; empty until one is met
  TechniqueTally techniques_;
  std::uint64_t samples_ = 0;
};

}  // namespace wander
