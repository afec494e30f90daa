// Do error bars tell the truth?  Over many runs, the variance that films claim against the one that they
// have:
//   ratio = bins / Σ_j (Var_runs I_j / mean claimed variance of I_j),
// with its own error from a jackknife over runs.  A variance is estimated without bias in bins that are
// not reliable, too; those in which some run found nothing are left out.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/chain_settings.h"
#include "tests/support/statistics.h"

namespace wander::test {

// Of a scene of the gallery.
struct RunsOfAMethod {
  const char* scene;
  const char* method;
  std::uint64_t samples;
  int runs;
  FilmParts parts = FilmParts::pooled;
};
std::ostream& operator<<(std::ostream& out, const RunsOfAMethod& c);

std::vector<FilmEstimate> films_of(const RunsOfAMethod& c);

struct ClaimedRatio {
  double value = 0, standard_error = 0;
  std::size_t bins = 0;
};
ClaimedRatio claimed_ratio(const std::vector<FilmEstimate>& films);

// That it is one but for `tolerance` and its own error.
Decision claimed_ratio_test(const ClaimedRatio& ratio, double tolerance, double false_alarm);
// Prints the ratio, and expects that it passes.
void expect_true_claims(const RunsOfAMethod& c, double tolerance);

}  // namespace wander::test
