// What an error on a bin is worth, when samples and chains share a film (partition.h): its square counts
// a_j times,
//   of a curve   a_j = 1: it is read on an even scale;
//   of an image  a_j ∝ 1 / (I + ε Ī): it is looked at, and an error shows beside the light that is there,
//                about as δ√I does.  On an even scale the highlights alone would decide.  I is that of
//                blocks of the image as samples know it, for of a pixel few paths say nothing.
// The scale is such that E_π[a] is about 1.
#pragma once

#include <span>
#include <vector>

#include "core/raster.h"
#include "mlt/run/trial_log.h"

namespace wander {

class BinWorth {
 public:
  // `resolution`: of the film.
  BinWorth(std::span<const int> resolution, std::span<const TrialFindings> groups);

  double operator()(int bin) const { return is_even() ? 1 : worth_[raster_.cell(bin)]; }
  bool is_even() const { return worth_.empty(); }

 private:
  static constexpr std::size_t most_blocks = 1 << 10;
  static constexpr double darkest = 0.05;  // ε

  Raster raster_;
  std::vector<double> worth_;  // of a block; of a curve, or of an image that is dark, none
};

}  // namespace wander
