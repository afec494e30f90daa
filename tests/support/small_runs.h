// What many runs say of themselves that are as small as runs can be, with groups as the program has them:
// of their films, the estimates of b, and the light of each length (claimed_errors.h).
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "core/film_estimate.h"
#include "tests/support/statistics.h"

namespace wander::test {

// Of a scene of the gallery, on one thread, with small moves as they are.
struct SmallRuns {
  const char* scene;
  const char* method;
  std::uint64_t samples, seeds;  // of the smallest of the runs that are merged
  int runs;
  int merged = 1;  // so many runs are merged into each, the k-th of k times the samples
};
std::ostream& operator<<(std::ostream& out, const SmallRuns& c);

// By what is claimed: "film", "by_length", and of chains "seed_pass", "least_squares", "bridge".  Values of a
// run side by side, as if they were the bins of a film.
using Claims = std::map<std::string, std::vector<FilmEstimate>>;
// Throws where an estimate of b failed.
Claims claims_of(const SmallRuns& c);
// The same with standard errors times `factor`.
Claims scaled_errors(Claims claims, double factor);

// Holds the mean claimed variance of each over the variance that it has over runs (ClaimedRatio) to one, all
// of them in one decision: its logarithm, whose law is about the same on both sides, to zero but for
// `tolerance`.  What it would have seen is a claim that is so much too large.
Decision claims_test(const Claims& claims, double tolerance, double false_alarm);

}  // namespace wander::test
