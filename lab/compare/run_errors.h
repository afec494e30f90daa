// The errors of one run, as compare.json and compare.csv list them.
#pragma once

#include "records/rendering.h"

namespace wander::compare {

// The reference's error is subtracted from squares.  Signed squares are unbiased; roots are never
// below zero.  With x the film and I the reference, in the words of comparison.h:
struct RunErrors {
  double relative_mse = not_known;   // m_r; may be negative
  double relative_rmse = not_known;  // √m_r
  double rmse = not_known, mae = not_known;
  double rel_mse = not_known;  // may be negative
  double mean = not_known, relative_error_of_mean = not_known;
  double claimed_relative_error = not_known;
  double coverage = not_known;  // share of reliable bins whose 95 % interval holds the reference
  double reliable_share = not_known;
};

}  // namespace wander::compare
