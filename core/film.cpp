#include "core/film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/reliability.h"

namespace wander {

std::size_t make_room(FilmEstimate& film) {
  const std::size_t bins = values_of(film.shape);
  film.value.reserve(bins);
  film.standard_error.reserve(bins);
  return bins;
}

void LengthFilms::merge(const LengthFilms& other) {
  for (std::size_t k = 0; k < films_.size(); ++k) {
    const auto& theirs = other.films_[k];
    if (theirs.empty()) continue;
    if (films_[k].empty()) films_[k].resize(theirs.size());
    for (std::size_t i = 0; i < theirs.size(); ++i) films_[k][i] += theirs[i];
  }
}

void LengthFilms::clear() {
  for (auto& film : films_) std::ranges::fill(film, Sum{});
}

std::vector<double> LengthFilms::by_bin() const {
  std::vector<Sum> sums(static_cast<std::size_t>(bins_));
  for (const auto& film : films_)
    for (std::size_t i = 0; i < film.size(); ++i) sums[i] += film[i];
  return values(sums);
}

std::vector<double> LengthFilms::by_length() const {
  std::vector<double> sums;
  for (const auto& film : films_) {
    Sum all;
    for (const Sum& x : film) all += x;
    sums.push_back(all.value());
  }
  return sums;
}

std::map<int, std::vector<double>> LengthFilms::scaled(double factor) const {
  std::map<int, std::vector<double>> films;
  for (std::size_t k = 0; k < films_.size(); ++k) {
    if (films_[k].empty()) continue;
    auto& film = films[static_cast<int>(k) + 2];
    for (const Sum& x : films_[k]) film.push_back(factor * x.value());
  }
  return films;
}

TechniqueTally::TechniqueTally(int max_vertices)
    : longest_(std::min(max_vertices, 64)),
      sums_(static_cast<std::size_t>(longest_ + 1) * static_cast<std::size_t>(longest_ + 1)) {}

void TechniqueTally::add(int vertices, int technique, double contribution) {
  sums_[index(vertices, technique)].add(contribution);
}

void TechniqueTally::merge(const TechniqueTally& other) {
  for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i].merge(other.sums_[i]);
}

void TechniqueTally::clear() { std::ranges::fill(sums_, BinSums{}); }

std::vector<RareTechnique> TechniqueTally::rare(double effective_samples) const {
  struct Found {
    BinSums sums;
    RareTechnique technique;
  };
  std::vector<Found> found;
  for (int n = 2; n <= longest_; ++n)
    for (int s = 0; s <= n; ++s)
      if (const BinSums& sums = sums_[index(n, s)];
          sums.sum > 0 && sums.effective_samples() < effective_samples)
        found.push_back({sums, {n, s, sums.sum}});
  std::ranges::stable_sort(found, std::greater(),
                           [](const Found& one) { return one.sums.squares / one.sums.sum; });
  std::vector<RareTechnique> rare;
  BinSums together;
  for (const Found& one : found) {
    together.merge(one.sums);
    if (together.effective_samples() >= effective_samples) break;
    rare.push_back(one.technique);
  }
  std::ranges::stable_sort(rare, std::greater(), &RareTechnique::light);
  return rare;
}

double TechniqueTally::rare_light(double effective_samples) const {
  double light = 0;
  for (const RareTechnique& technique : rare(effective_samples)) light += technique.light;
  return light;
}

BinSums TechniqueTally::lights_met() const {
  BinSums hits;
  for (int n = 3; n <= longest_; ++n) hits.merge(sums_[index(n, 0)]);
  return hits;
}

BinSums TechniqueTally::sensors_met() const {
  BinSums hits;
  for (int n = 3; n <= longest_; ++n) hits.merge(sums_[index(n, n)]);
  return hits;
}

SampleFilm::SampleFilm(int bins, int max_vertices, const FilmLayout& layout)
    : sum_(static_cast<std::size_t>(bins)),
      squares_(static_cast<std::size_t>(bins)),
      current_(static_cast<std::size_t>(bins)),
      lengths_(bins, layout.keeps_lengths(std::array{bins}, max_vertices) ? max_vertices - 1 : 0),
      techniques_(max_vertices) {
  touched_.reserve(static_cast<std::size_t>(std::min(bins, 1 << 16)));
}

void SampleFilm::add(int vertices, int technique, int bin, double contribution) {
  double& x = current_[static_cast<std::size_t>(bin)];
  if (x == 0) touched_.push_back(bin);
  x += contribution;
  lengths_.add(vertices, bin, contribution);
  techniques_.add(vertices, technique, contribution);
}

void SampleFilm::end_sample() {
  for (const int bin : touched_) {
    const auto i = static_cast<std::size_t>(bin);
    sum_[i] += current_[i];
    squares_[i] += current_[i] * current_[i];
    current_[i] = 0;
  }
  touched_.clear();
  ++samples_;
}

void SampleFilm::add(const Contributions& sample) {
  for (const Contribution& c : sample) add(c.vertices, c.technique, c.bin, c.value);
  end_sample();
}

void SampleFilm::merge(const SampleFilm& other) {
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    sum_[i] += other.sum_[i];
    squares_[i] += other.squares_[i];
  }
  lengths_.merge(other.lengths_);
  techniques_.merge(other.techniques_);
  samples_ += other.samples_;
}

void SampleFilm::clear() {
  std::ranges::fill(sum_, Sum{});
  std::ranges::fill(squares_, Sum{});
  lengths_.clear();
  techniques_.clear();
  samples_ = 0;
}

FilmEstimate SampleFilm::estimate(std::span<const int> shape) const {
  FilmEstimate film = estimate_of_samples(shape, samples_, techniques_, [this](std::size_t bin) {
    return BinSums{sum_[bin].value(), squares_[bin].value()};
  });
  film.by_length = lengths_.scaled(
      samples_ > 0 ? static_cast<double>(sum_.size()) / static_cast<double>(samples_) : 0);
  return film;
}

double fewest_on_film(std::span<const int> shape) {
  return fewest_in_neighbourhood *
         std::max(1.0, static_cast<double>(values_of(pixels_of(shape))) / bins_of_neighbourhood);
}

std::vector<bool> without_rare_light(const FilmEstimate& film, const TechniqueTally& techniques,
                                     std::uint64_t samples) {
  // What a bin would have of it, were it spread evenly.
  const double rare = techniques.rare_light(fewest_on_film(film.shape)) /
                      static_cast<double>(std::max<std::uint64_t>(samples, 1));
  std::vector<bool> without;
  without.reserve(film.value.size());
  for (const double error : film.standard_error) without.push_back(rare <= most_rare_light * error);
  return without;
}

// The value of a pixel is pixels · E[x]: the mean of the film is E of a whole sample.
FilmEstimate estimate_of_samples(std::span<const int> shape, std::uint64_t samples,
                                 const TechniqueTally& techniques,
                                 const std::function<BinSums(std::size_t bin)>& sums) {
  FilmEstimate film{.shape = {shape.begin(), shape.end()}};
  const std::size_t count = make_room(film);
  const double n = static_cast<double>(samples),
               pixels = static_cast<double>(count) / channels_of(shape);
  film.degrees_of_freedom = film.degrees_of_error = std::max(0.0, n - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const BinSums of_bin = sums(i);
    const double sum = of_bin.sum,
                 variance = std::max(0.0, of_bin.squares - sum * sum / n) / (n - 1);
    film.value.push_back(samples > 0 ? pixels * sum / n : 0);
    film.standard_error.push_back(samples > 1 ? pixels * std::sqrt(variance / n)
                                              : std::numeric_limits<double>::quiet_NaN());
  }
  const std::vector<bool> without = without_rare_light(film, techniques, samples);
  film.reliable = reliability(film, EventWeight::of_samples(samples));
  for (std::size_t i = 0; i < count; ++i) film.reliable[i] = film.reliable[i] && without[i];
  return film;
}

}  // namespace wander
