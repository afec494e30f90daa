// The normalization constant b = ∫ f, the mean of the film, and its share by path length: three
// estimates, always made.
//
//   seed_pass       the mean of the seed pass, unbiased, with the error of independent samples
//   least_squares   the factor between the film of the seed pass and that of the chains (film_fit.h)
//   bridge          f / p̄ of the seed pass against that of the states of the chains (bridge.h)
//
// Of a pooled film (pooled_film.h) there is a fourth, `pooled`, the bridge with the balance of its border,
// for comparison.
//
// The error of the last two is a delete-a-group jackknife: a group takes its slice of the seed pass
// and its chains along, which start from that slice, so what the two have in common counts, too.
#pragma once

#include <span>

#include "mlt/run/group_findings.h"
#include "mlt/run/normalization_record.h"

namespace wander {

enum class NormalizationMethod { seed_pass, least_squares, bridge, pooled };
std::string_view name_of(NormalizationMethod method);

// An estimate of b, and the same from all groups but one.
struct Constant {
  Estimate b{not_known, not_known};
  std::vector<double> without{};
  double effective_samples = 0;  // of the seed pass that carry it
  double degrees_of_freedom = 0;
  std::string failure{};  // why there is none; empty if there is
};

struct Constants {
  Constant seed_pass, least_squares, bridge;
  Constant pooled{.failure = "the film is not pooled"};

  const Constant& operator[](NormalizationMethod method) const;
  // The method itself; the seed pass where it failed.
  NormalizationMethod usable(NormalizationMethod method) const;
};
Constants constants(std::span<const GroupFindings> groups);

// For a record: the usable estimate, all three, and the shares of path lengths.
Normalization normalization(std::span<const GroupFindings> groups, const Constants& constants,
                            NormalizationMethod method);
// The seed pass alone.
Normalization normalization(const SeedTally& tally);

// Do the bridge and the mean of the seed pass contradict each other, by more than this many
// standard errors of both together?  In words, with the class of paths in which they do; else
// empty.
inline constexpr double largest_disagreement = 4;
std::string disagreement_of_constants(std::span<const GroupFindings> groups,
                                      const Constants& constants);

}  // namespace wander
