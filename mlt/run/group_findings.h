// What one group of chains found: everything that the normalization of a film and its error bars
// are made of.  Groups are independent of each other.
#pragma once

#include <span>
#include <vector>

#include "mlt/run/group_films.h"
#include "mlt/seeds/seed_pass.h"

namespace wander {

// The chains' side of the comparison with the seed pass, by stratum (seeds.h): the ratios f / p̄ of
// all states, each of which weighs so much among the states of all groups.
struct StateRatios {
  const RatioHistogram* ratios = nullptr;
  double weight = 0;
};

// So much light was found in paths of a class, in the unit of the film's deposits.
struct ClassLight {
  PathClass path_class = other_class;
  double light = 0;
};

struct GroupFindings {
  const SeedTally* seeds;     // of all samples
  const SeedTally* of_seeds;  // of those that the chains started from
  const SeedEvidence* evidence;
  const GroupFilm* film;               // of all that the chains deposited
  std::span<const PooledParts> parts;  // one, of a pooled film
  double scale;  // makes of deposits an estimate of the light that falls on a bin, times `weight`
  std::vector<StateRatios> states{};
  std::vector<ClassLight> classes{};  // empty where states have no class
  // How much it counts among groups that have done more or less than it.  It must not depend on
  // what the group found, or products of seeds and constants are biased.
  double weight = 1;

  GroupFindings weighing(double w) const;
};
std::vector<double> weights_of(std::span<const GroupFindings> groups);

// A copy of what a group found, for when the group is gone.
class KeptFindings {
 public:
  explicit KeptFindings(const GroupFindings& found);
  KeptFindings(const KeptFindings&) = delete;
  KeptFindings& operator=(const KeptFindings&) = delete;

  const GroupFindings& found() const { return found_; }

 private:
  SeedTally seeds_, of_seeds_;
  SeedEvidence evidence_;
  GroupFilm film_;
  std::vector<PooledParts> parts_;
  std::vector<RatioHistogram> states_;
  GroupFindings found_;  // of the members above
};

}  // namespace wander
