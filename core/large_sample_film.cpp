#include "core/large_sample_film.h"

#include <algorithm>

namespace wander {

SampleList::SampleList(std::span<const int> shape, int max_vertices, const FilmLayout& layout)
    : keeps_lengths_(layout.keeps_lengths(shape, max_vertices)),
      channels_(channels_of(shape)),
      techniques_(max_vertices) {}

void SampleList::add(const Contributions& sample) {
  const std::size_t begin = bins_.size();
  for (const Contribution& c : sample) {
    techniques_.add(c.vertices, c.technique, c.value);
    OfBin* const channels = channels_of_pixel(c.bin, begin);
    for (int k = 0; k < channels_; ++k) {
      const double value = c.value * c.tint[static_cast<std::size_t>(k)];
      if (keeps_lengths_) lengths_.push_back({c.vertices, channels[k].bin, value});
      channels[k].value += value;
    }
  }
  ++samples_;
}

SampleList::OfBin* SampleList::channels_of_pixel(int pixel, std::size_t begin) {
  const int first = pixel * channels_;
  const auto step = static_cast<std::size_t>(channels_);
  for (std::size_t k = begin; k < bins_.size(); k += step)
    if (bins_[k].bin == first) return &bins_[k];
  const std::size_t size = bins_.size();
  for (int k = 0; k < channels_; ++k) bins_.push_back({first + k, 0});
  return &bins_[size];
}

void SampleList::clear() {
  bins_.clear();
  lengths_.clear();
  techniques_.clear();
  samples_ = 0;
}

LargeSampleFilm::LargeSampleFilm(std::span<const int> shape, int max_vertices,
                                 const FilmLayout& layout)
    : sums_(values_of(shape)), techniques_(max_vertices) {
  if (layout.keeps_lengths(shape, max_vertices))
    lengths_.resize(static_cast<std::size_t>(max_vertices) - 1);
}

void LargeSampleFilm::merge(const SampleList& part) {
  for (const SampleList::OfBin& found : part.bins_) {
    BinSums& sums = sums_[static_cast<std::size_t>(found.bin)];
    sums.sum += found.value;
    sums.squares += found.value * found.value;
  }
  for (const SampleList::OfLength& found : part.lengths_) {
    auto& film = lengths_[static_cast<std::size_t>(found.vertices) - 2];
    film.resize(sums_.size());
    film[static_cast<std::size_t>(found.bin)] += found.value;
  }
  techniques_.merge(part.techniques_);
  samples_ += part.samples_;
}

void LargeSampleFilm::merge(const LargeSampleFilm& other) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sums_[i].sum += other.sums_[i].sum;
    sums_[i].squares += other.sums_[i].squares;
  }
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    lengths_[k].resize(std::max(lengths_[k].size(), other.lengths_[k].size()));
    for (std::size_t i = 0; i < other.lengths_[k].size(); ++i)
      lengths_[k][i] += other.lengths_[k][i];
  }
  techniques_.merge(other.techniques_);
  samples_ += other.samples_;
}

FilmEstimate LargeSampleFilm::estimate(std::span<const int> shape) const {
  FilmEstimate film = estimate_of_samples(shape, samples_, techniques_,
                                          [this](std::size_t bin) { return sums_[bin]; });
  film.by_length = by_length(shape);
  return film;
}

std::map<int, std::vector<double>> LargeSampleFilm::by_length(std::span<const int> shape) const {
  std::map<int, std::vector<double>> films;
  const double scale = samples_ > 0 ? static_cast<double>(sums_.size()) / channels_of(shape) /
                                          static_cast<double>(samples_)
                                    : 0;
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    if (lengths_[k].empty()) continue;
    auto& values = films[static_cast<int>(k) + 2] = lengths_[k];
    for (double& value : values) value *= scale;
  }
  return films;
}

}  // namespace wander
