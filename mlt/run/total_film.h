// The sum of the deposits of all chains on the pixels of a large film: the film of the chains alone,
// where the films that groups share (shared_films.h) hold what the chains bring to a pooled one.
//
// Numbers are whole multiples of 2^-24, in 64 bits, so that their sum is the same in whatever order
// threads add.  Rounding is to the nearest, wrong by at most 2^-25 a deposit.  A bin is full at 2^39: a
// deposit is of the order of one, and at most some thousands (a tint of pure blue has 14; a step of MMLT
// stands for 1/q_n; one of a chain with an even target shows 1/v of light).
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/tint.h"

namespace wander {

class TotalFilm {
 public:
  explicit TotalFilm(std::size_t bins) : sums_(bins) {}

  // To all channels of a pixel, by any thread.
  template <int Channels>
  void add(int pixel, double weight, const Tint<Channels>& colour) {
    for (int k = 0; k < Channels; ++k) {
      std::atomic_ref<std::int64_t> sum(sums_[static_cast<std::size_t>(pixel * Channels + k)]);
      sum.fetch_add(std::llround(weight * colour[k] * 0x1p24), std::memory_order_relaxed);
    }
  }

  std::size_t bins() const { return sums_.size(); }
  double operator[](std::size_t bin) const { return static_cast<double>(sums_[bin]) * 0x1p-24; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(sums_);
  }

 private:
  std::vector<std::int64_t> sums_;
};

}  // namespace wander
