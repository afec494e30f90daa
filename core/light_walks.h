// The random numbers of many walks of light at once: the first vertices of a batch of walks take
// theirs from one low-discrepancy sequence, all later ones from independent numbers.
//
// Batch b holds the points of Sobol's sequence, shifted by a random vector of its own modulo 1
// [Sobol' 1967; Cranley and Patterson 1976]: a batch is spread evenly over light, position and the
// first directions, its mean is unbiased, and batches are independent of each other, so that their
// spread is the error.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/random_place.h"
#include "core/rng.h"

namespace wander {

// The points that all batches share.
class EvenPoints {
 public:
  static constexpr int vertices = 8;            // whose numbers are spread evenly
  static constexpr int numbers_per_vertex = 3;  // roulette, direction and lobe; or light, position
  static constexpr int dimensions = vertices * numbers_per_vertex;
  using Point = std::array<double, dimensions>;

  explicit EvenPoints(std::uint64_t count);

  std::uint64_t count() const { return points_.size(); }
  const Point& operator[](std::uint64_t k) const { return points_[k]; }

 private:
  std::vector<Point> points_;
};

// Walk by walk, the numbers of one batch.
class BatchRandom {
 public:
  BatchRandom(const EvenPoints& points, std::uint64_t seed)
      : points_(&points), later_(seed, Purpose::estimate, 0), shifts_(seed, Purpose::estimate, 1) {}

  void start_batch(std::uint64_t batch) {
    shifts_.start(batch);
    for (double& shift : shift_) shift = shifts_.uniform();
  }
  // Walk `k` of its batch, and `number` of all.
  void start_walk(std::uint64_t k, std::uint64_t number) {
    point_ = &(*points_)[k];
    later_.start(number);
    seek({Subpath::light, 0});
  }
  void seek(RandomPlace place) {
    next_ = place.vertex * EvenPoints::numbers_per_vertex;
    end_ = next_ + EvenPoints::numbers_per_vertex;
    if (place.vertex >= EvenPoints::vertices) next_ = end_ = 0;
  }
  double uniform() {
    if (next_ >= end_) return later_.uniform();
    const auto k = static_cast<std::size_t>(next_++);
    const double u = (*point_)[k] + shift_[k];
    return u < 1 ? u : u - 1;
  }

 private:
  const EvenPoints* points_;
  Rng later_, shifts_;
  EvenPoints::Point shift_{};
  const EvenPoints::Point* point_ = nullptr;
  int next_ = 0, end_ = 0;
};

}  // namespace wander
