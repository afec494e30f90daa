#include "mlt/run/group_findings.h"

namespace wander {

GroupFindings GroupFindings::weighing(double w) const {
  GroupFindings weighed = *this;
  weighed.weight *= w;
  weighed.scale *= w;
  for (StateRatios& stratum : weighed.states) stratum.weight *= w;
  for (ClassLight& each : weighed.classes) each.light *= w;
  return weighed;
}

std::vector<double> weights_of(std::span<const GroupFindings> groups) {
  std::vector<double> weights;
  for (const GroupFindings& group : groups) weights.push_back(group.weight);
  return weights;
}

KeptFindings::KeptFindings(const GroupFindings& found)
    : seeds_(*found.seeds),
      of_seeds_(*found.of_seeds),
      evidence_(*found.evidence),
      film_(*found.film),
      found_(found) {
  for (const StateRatios& stratum : found.states) states_.push_back(*stratum.ratios);
  found_.seeds = &seeds_;
  found_.of_seeds = &of_seeds_;
  found_.evidence = &evidence_;
  found_.film = &film_;
  parts_.assign(found.parts.begin(), found.parts.end());
  found_.parts = parts_;
  for (std::size_t k = 0; k < states_.size(); ++k) found_.states[k].ratios = &states_[k];
}

}  // namespace wander
