#include "core/batch_picture.h"

#include <algorithm>
#include <cmath>

#include "core/film_layout.h"
#include "core/reliability.h"

namespace wander {

namespace {

// Fewer batches do not tell an error.
constexpr std::uint64_t fewest_batches = 16;

void add_scaled(std::vector<double>& sum, const std::vector<double>& cells, double factor) {
  for (std::size_t i = 0; i < cells.size(); ++i) sum[i] += factor * cells[i];
}

}  // namespace

void BatchDeposit::clear() {
  for (auto& cells : by_length_) std::ranges::fill(cells, 0);
}

BatchPicture::BatchPicture(std::size_t cells, int max_vertices)
    : mean_(cells),
      spread_(cells),
      keeps_lengths_(static_cast<std::int64_t>(cells) * (max_vertices - 1) <= most_length_values) {}

// The mean and its spread after West [1979].
void BatchPicture::add(const BatchDeposit& batch, std::uint64_t samples) {
  const auto count = static_cast<double>(samples);
  samples_ += samples;
  ++batches_;
  std::vector<double> of_batch(mean_.size());
  for (std::size_t n = 0; n < batch.by_length().size(); ++n) {
    const std::vector<double>& cells = batch.by_length()[n];
    if (cells.empty()) continue;
    add_scaled(of_batch, cells, 1 / count);
    if (!keeps_lengths_) continue;
    std::vector<double>& film = by_length_[static_cast<int>(n) + 2];
    film.resize(mean_.size());
    add_scaled(film, cells, 1);
  }
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const double off = of_batch[i] - mean_[i];
    mean_[i] += off * count / static_cast<double>(samples_);
    spread_[i] += count * off * (of_batch[i] - mean_[i]);
  }
}

FilmEstimate BatchPicture::estimate(std::vector<int> shape, double scale) const {
  const auto count = static_cast<double>(samples_), batches = static_cast<double>(batches_);
  FilmEstimate film;
  film.shape = std::move(shape);
  film.degrees_of_freedom = film.degrees_of_error = batches - 1;
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    const double variance = batches_ > 1 ? spread_[i] / (count * (batches - 1)) : not_known;
    film.value.push_back(scale * mean_[i]);
    film.standard_error.push_back(scale * std::sqrt(variance));
    // The relative error of so many effective samples.
    film.reliable.push_back(batches_ >= fewest_batches && mean_[i] > 0 &&
                            variance * fewest_effective_samples <= mean_[i] * mean_[i]);
  }
  for (const auto& [vertices, sums] : by_length_) {
    std::vector<double>& values = film.by_length[vertices];
    values.resize(sums.size());
    add_scaled(values, sums, scale / count);
  }
  return film;
}

}  // namespace wander
