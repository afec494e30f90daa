// A picture that batches of samples make: their mean, and the spread of their means as its error.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// What one batch deposits, by number of vertices and cell.
class BatchDeposit {
 public:
  BatchDeposit(std::size_t cells, int max_vertices)
      : cells_(cells), by_length_(static_cast<std::size_t>(max_vertices) - 1) {}

  // The cells of this length, to be added to.
  std::vector<double>& of_length(int vertices) {
    auto& cells = by_length_[static_cast<std::size_t>(vertices) - 2];
    if (cells.empty()) cells.resize(cells_);
    return cells;
  }
  const std::vector<std::vector<double>>& by_length() const { return by_length_; }
  void clear();

 private:
  std::size_t cells_;
  std::vector<std::vector<double>> by_length_;  // at vertices - 2; empty: nothing yet
};

// Sums over batches, in the order in which they are added.
class BatchPicture {
 public:
  // A picture of many cells and lengths is not kept by length (film.h).
  BatchPicture(std::size_t cells, int max_vertices);

  void add(const BatchDeposit& batch, std::uint64_t samples);
  std::uint64_t samples() const { return samples_; }
  // Per sample, times `scale`.
  FilmEstimate estimate(std::vector<int> shape, double scale) const;

 private:
  std::vector<double> mean_, spread_;  // Σ n_b (x_b - mean)² over batches of n_b samples
  std::map<int, std::vector<double>> by_length_;
  bool keeps_lengths_;
  std::uint64_t samples_ = 0, batches_ = 0;
};

}  // namespace wander
