#include "core/raster.h"

namespace wander {

Raster::Raster(std::span<const int> film, std::size_t most_cells)
    : width_(film.back()), per_width_(1.0 / width_) {
  for (shift_ = 0;; ++shift_) {
    shape_.clear();
    cells_ = 1;
    for (const int extent : film) {
      shape_.push_back(((extent - 1) >> shift_) + 1);
      cells_ *= static_cast<std::size_t>(shape_.back());
    }
    if (cells_ <= most_cells || cells_ == 1) return;
  }
}

}  // namespace wander
