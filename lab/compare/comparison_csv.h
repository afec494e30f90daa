// `compare.csv`: a row for each run, in the order in which they were made.
//
//   contender        label of the table and the figures
//   method           of --method
//   dial, setting    in which the contender differs from the base point of its method; empty there
//   budget           as given: 8s, 2M
//   replicate        from 1
//   seed, samples    of the run, without those of the seed pass
//   seconds          wall time, seed pass included; seed_seconds: of which seed pass
//   seed_samples     of the seed pass
//   relative_mse ... reliable_share    the errors of run_errors.h, by their names there
//
// All of it was measured: nothing here is extrapolated.
// Numbers read back to the same double; what is not known is `nan`.  A text with a comma, a quote
// or a line break is quoted as RFC 4180 says.
#pragma once

#include <string>

#include "lab/compare/comparison.h"

namespace wander::compare {

std::string to_csv(const Comparison& comparison);

}  // namespace wander::compare
