// A coarser film: what is kept per place of a large film is kept per block of its bins, so that it
// stays small.  A film that is small enough is its own raster.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wander {

class Raster {
 public:
  // Of a film in one dimension that is its own raster.
  Raster(int bins) : cells_(static_cast<std::size_t>(bins)), shape_{bins} {}
  // Blocks whose edges are the least power of two with which there are no more cells than this.
  Raster(std::span<const int> film, std::size_t most_cells);

  std::size_t cell(int bin) const {
    if (shift_ == 0) return static_cast<std::size_t>(bin);
    const int row = static_cast<int>((bin + 0.5) * per_width_), column = bin - row * width_;
    return static_cast<std::size_t>((row >> shift_) * shape_.back() + (column >> shift_));
  }
  std::size_t cells() const { return cells_; }
  const std::vector<int>& shape() const { return shape_; }  // fastest axis last
  bool is_film() const { return shift_ == 0; }

 private:
  int shift_ = 0;         // log2 of the edge of a block
  int width_ = 1;         // of the film
  double per_width_ = 1;  // half a bin is more than it is off by, for all of them
  std::size_t cells_;
  std::vector<int> shape_;
};

}  // namespace wander
