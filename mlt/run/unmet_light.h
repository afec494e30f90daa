// Light that samples found and chains did not meet, by the classes of its paths.
//
// Chains that hardly come from one kind of path to another know as much of a kind as there are chains that began in it;
// where none did, their groups are alike, and how they differ says nothing of it.  A class tells that, or an octave of l
// (bridge.cpp), and of what few samples found, too: were chains to come and go, those of many groups would have been there.
#pragma once

#include <span>

#include "mlt/run/group_findings.h"

namespace wander {

// Of a kind of light that so many groups met: is it unmet, were so many states of each to be there by its share?
inline bool is_unmet(int groups, double states_of_each) {
  constexpr int most_groups = 1;
  constexpr double fewest_states = 2;
  return groups <= most_groups && states_of_each >= fewest_states;
}

// As a share of what is measured (light, or that of a map v): what the samples with seeds found in classes where the states of no more than one group were, though
// they would be a few in each, over the share that the states have there.  What states have more of than samples in the paths
// that have no class of their own (path_class.h) may be of these classes.  0 where states have no class.
double unmet_light(std::span<const GroupFindings> groups);

}  // namespace wander
