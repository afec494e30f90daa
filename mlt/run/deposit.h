// From steps to a film.  Expected values [Veach 1997, 11.3.2; "waste recycling"]: each step
// deposits 1 - a at x and a at y, whatever was decided, so the deposits of n steps sum to n.  How
// much of a deposit the pooled film takes is said in partition.h.
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "core/film.h"
#include "mlt/chain.h"
#include "mlt/run/shared_films.h"
#include "mlt/run/total_film.h"

namespace wander {

// The deposits of one group of chains: its film, or of a large one a raster, while the pixels are in
// a film that it shares with other groups.  A deposit is added once: to the film of its length, where these are
// kept, of which all else is a sum.
class GroupFilm {
 public:
  // A film in one dimension.
  GroupFilm(int bins, int max_vertices) : GroupFilm(std::array{bins}, max_vertices, {}) {}
  // Of this shape.
  GroupFilm(std::span<const int> film, int max_vertices, const FilmLayout& layout)
      : raster_(layout.raster(film)),
        lengths_(static_cast<int>(raster_.cells()),
                 !layout.is_large(film) && layout.keeps_lengths(film, max_vertices)
                     ? max_vertices - 1
                     : 0) {
    if (lengths_.keeps_any()) return;
    weights_.resize(raster_.cells());
    by_length_.resize(static_cast<std::size_t>(max_vertices) - 1);
  }

  // Before the first deposit, of a large film: where its pixels are; there a deposit counts so many
  // times.
  void share(SharedFilm& pixels, double factor) {
    pixels_ = &pixels;
    factor_ = factor;
  }
  void share(TotalFilm& pixels, double factor) {
    total_ = &pixels;
    factor_ = factor;
  }

  // Of luminance `weight`.
  template <int Channels = 1>
  void add(int vertices, int bin, double weight, const Tint<Channels>& colour = {}) {
    if (lengths_.keeps_any()) return lengths_.add(vertices, bin, weight);
    weights_[raster_.cell(bin)] += weight;
    by_length_[static_cast<std::size_t>(vertices) - 2] += weight;
    if (pixels_)
      pixels_->add(vertices, bin, factor_ * weight, colour);
    else if (total_)
      total_->add(bin, factor_ * weight, colour);
  }
  // Of all bins, at once: what is kept by length is summed length by length, as it lies in memory.
  std::vector<double> weights() const {
    return lengths_.keeps_any() ? lengths_.by_bin() : values(weights_);
  }
  // Of the raster.
  std::size_t bins() const { return raster_.cells(); }
  const std::vector<int>& shape() const { return raster_.shape(); }
  // Of paths of n vertices over the whole film, at n - 2.
  std::vector<double> by_length() const;
  const LengthFilms& lengths() const { return lengths_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(weights_, by_length_, lengths_);
  }

 private:
  Raster raster_;
  LengthFilms lengths_;
  std::vector<Sum> weights_, by_length_;  // where no films of lengths are kept
  SharedFilm* pixels_ = nullptr;
  TotalFilm* total_ = nullptr;
  double factor_ = 1;
};

// The deposits of a step: put(path, vertices, bin, weight, colour).
template <class Space, class Put>
void for_each_deposit(const Space& space, const Step<typename Space::Universe>& step,
                      int current_bin, Put&& put) {
  const auto& [x, y] = std::tie(step.current, step.proposed);
  if (step.acceptance < 1) put(x, x.size(), current_bin, 1 - step.acceptance, colour(x));
  if (step.acceptance > 0) put(y, y.size(), space.bin(y), step.acceptance, colour(y));
}

// The film of all groups.  Group g estimates a bin by bins · b_g · (its share of the deposits); the
// groups are independent, so their mean has the standard error of a mean (which is the
// delete-a-group jackknife), with G - 1 degrees of freedom.  A group whose slice found no light
// contributes zero.
class GroupsFilm {
 public:
  // With fewer groups than this no error bar is trusted.
  static constexpr int fewest_groups = 16;

  explicit GroupsFilm(std::vector<int> resolution);

  // `b` is the group's own estimate; `steps` how many its chains made.
  void add(const GroupFilm& film, double b, std::uint64_t steps);
  void add_dark_group();

  FilmEstimate estimate() const;
  const std::vector<int>& resolution() const { return resolution_; }

 private:
  std::vector<int> resolution_;
  std::vector<double> mean_, squares_;  // Welford over groups
  std::map<int, std::vector<double>> lengths_;
  int groups_ = 0;
};

}  // namespace wander
