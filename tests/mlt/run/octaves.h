// Do the states of chains agree with what samples found, octave by octave of l = f / p̄?  The bridge leans on states less where
// they do not, so b alone does not say it.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mlt/run/bridge_cells.h"
#include "mlt/run/group_findings.h"
#include "mlt/seeds/seed_pass.h"

namespace wander::test {

// By how many standard errors the light that samples have found in an octave differs at most from the share of the states
// there; of one stratum.  0 where one side is empty.
inline double largest_difference(std::span<const GroupFindings> findings, std::size_t stratum) {
  std::vector<BridgeGroup> sides;
  for (const GroupFindings& group : findings)
    sides.push_back({&group.evidence->ratios[stratum], static_cast<double>(group.seeds->samples),
                     group.states[stratum].ratios, group.states[stratum].weight});
  const Cells cells(sides);
  if (!(cells.direct() > 0) || !cells.has_states()) return 0;
  double largest = 0;
  for (const Cells::Octave& octave : cells.octaves(1, [](double) { return 1; }))
    largest = std::max(largest, std::abs(octave.light - octave.states) / octave.error);
  return largest;
}

}  // namespace wander::test
