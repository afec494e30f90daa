// What an error on a bin is worth, when samples and chains share a film (partition.h): its square counts
// a_j times,
//   of a curve   a_j = 1: it is read on an even scale;
//   of an image  a_j ∝ 1 / (I + ε Ī): it is looked at, and an error shows beside the light that is there,
//                about as δ√I does.  On an even scale the highlights alone would decide.  I is that of
//                the test image that the samples are (test_image.h).  Where what is measured is f v, already
//                by such a factor, I is the measure of a cell, and there is little left to even.
// The scale is such that E_π[a] is about 1.
#pragma once

#include <optional>
#include <span>

#include "mlt/run/test_image.h"
#include "mlt/run/trial_log.h"

namespace wander {

class BinWorth {
 public:
  // `resolution`: of the film.
  BinWorth(std::span<const int> resolution, std::span<const TrialFindings> groups);

  double operator()(int bin) const { return worth_ ? (*worth_)(bin).v : 1; }
  bool is_even() const { return !worth_.has_value(); }

 private:
  std::optional<ImportanceMap> worth_;  // of a curve, or of an image that is dark, none
};

}  // namespace wander
