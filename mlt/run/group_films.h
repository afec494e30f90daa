// What one group brings to the films of a run: the deposits of its chains; and if the film is pooled
// (partition.h), what of them is the chains' part, and the samples' part from its slice of the seed
// pass.
#pragma once

#include <optional>

#include "core/large_sample_film.h"
#include "mlt/run/class_parts.h"
#include "mlt/run/deposit.h"
#include "mlt/run/partition.h"
#include "mlt/seeds/seed_pass.h"

namespace wander {

// The parts of a pooled film.  Of a large film, samples come as lists, which are to be taken from here
// now and then.
class PooledParts {
 public:
  PooledParts(const Pooling& pooling, std::span<const int> film, int max_vertices,
              const FilmLayout& layout)
      : pooling_(pooling),
        of_chains_(film, max_vertices, layout),
        techniques_(max_vertices),
        easy_by_length_(static_cast<std::size_t>(max_vertices) - 1),
        list_(film, max_vertices, layout) {
    if (!layout.is_large(film)) of_samples_.emplace(film, max_vertices, layout);
  }

  const Pooling& pooling() const { return pooling_; }
  const Partition& partition() const { return pooling_.partition; }
  GroupFilm& of_chains() { return of_chains_; }
  const GroupFilm& of_chains() const { return of_chains_; }
  // Σ over samples; of a film that is not large.
  const GroupFilm& of_samples() const { return of_samples_.value(); }

  // A state of the chains that shows so much light.
  void add_state(PathClass path_class, double ratio, double light) {
    classes_.add(path_class, partition().of_chains(ratio), light);
  }
  const ClassParts& classes() const { return classes_; }  // empty where states have no class

  // What a path of l = `ratio` brings that is `light` of its sample; of a film that is not large.
  bool takes_paths() const { return of_samples_.has_value(); }
  void add_path(int vertices, int technique, int bin, double light, double ratio) {
    const double easy = light * partition().of_samples(ratio);
    of_samples_->add(vertices, bin, easy);
    count(vertices, technique, easy);
  }
  // A whole sample, of which each path comes with the light l w_B.
  void add_sample(const Contributions& sample) {
    for (const Contribution& path : sample) {
      if (of_samples_) of_samples_->add(path.vertices, path.bin, path.value);
      count(path.vertices, path.technique, path.value);
    }
    if (!of_samples_) list_.add(sample);
  }
  // Σ l w_B and its square over all paths that samples found.
  double easy_light() const { return easy_.value(); }
  // Of paths of n vertices, at n - 2.
  std::vector<double> easy_light_by_length() const { return values(easy_by_length_); }
  double easy_squares() const { return easy_squares_.value(); }
  const TechniqueTally& techniques() const { return techniques_; }  // of l w_B
  // Of a large film, since the last time.
  void move_samples_to(LargeSampleFilm& film) {
    film.merge(list_);
    list_.clear();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(of_chains_, classes_, easy_, easy_squares_, techniques_, easy_by_length_);
    if (of_samples_) archive(*of_samples_);
  }

 private:
  void count(int vertices, int technique, double easy) {
    techniques_.add(vertices, technique, easy);
    easy_by_length_[static_cast<std::size_t>(vertices) - 2] += easy;
    easy_ += easy;
    easy_squares_ += easy * easy;
  }

  Pooling pooling_;
  GroupFilm of_chains_;
  ClassParts classes_;
  Sum easy_, easy_squares_;
  TechniqueTally techniques_;
  std::vector<Sum> easy_by_length_;
  std::optional<GroupFilm> of_samples_;
  SampleList list_;  // empty when a run is kept
};

// Brings samples to the film.  `R` says what l is of: of a path, or of a whole sample.
template <class W, Ratios R>
class SampleWatcher {
 public:
  explicit SampleWatcher(PooledParts& parts) : parts_(&parts) {}

  // By the balance heuristic w f/p is l, or the part of it that a path is of a sample.
  void found(const JoinedPath<W>& x, const FoundPath& path) {
    const auto& [bin, technique, ratio, light] = path;
    if (R == Ratios::of_paths && parts_->takes_paths())
      return parts_->add_path(x.size(), technique, bin, light, ratio);
    if (R == Ratios::of_paths)
      sample_.push_back({x.size(), technique, bin, light * parts_->partition().of_samples(ratio)});
    else
      sample_.push_back({x.size(), technique, bin, light});
    if constexpr (W::channels > 1) sample_.back().tint = x.colour().colour;
  }
  void end_sample(double total) {
    if (R == Ratios::of_paths && parts_->takes_paths()) return;
    if (R == Ratios::of_samples)
      for (Contribution& path : sample_) path.value *= parts_->partition().of_samples(total);
    parts_->add_sample(sample_);
    sample_.clear();
  }

 private:
  PooledParts* parts_;
  Contributions sample_;  // under way
};

}  // namespace wander
