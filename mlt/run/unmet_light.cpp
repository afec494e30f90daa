#include "mlt/run/unmet_light.h"

#include <algorithm>
#include <map>

namespace wander {

namespace {

struct OfClass {
  double samples = 0, states = 0;  // light
  int met = 0;                     // by so many groups
};

}  // namespace

double unmet_light(std::span<const GroupFindings> groups) {
  std::map<PathClass, OfClass> classes;
  OfClass all;
  double number_of_states = 0;
  for (const GroupFindings& group : groups) {
    const SeedEvidence& evidence = *group.evidence;
    for (std::size_t c = 0; c < evidence.classes.size(); ++c) {
      const double light = evidence.by_class[c].value();
      classes[evidence.classes.code(c)].samples += light;
      all.samples += light;
    }
    for (const auto& [path_class, light] : group.classes) {
      OfClass& met = classes[path_class];
      met.states += group.weight * light;
      met.met += light > 0 ? 1 : 0;
      all.states += group.weight * light;
    }
    for (const StateRatios& stratum : group.states) number_of_states += stratum.ratios->count();
  }
  if (!(all.states > 0) || !(all.samples > 0)) return 0;
  const double of_each = number_of_states / static_cast<double>(groups.size());
  double unmet = 0;
  for (const auto& [path_class, light] : classes) {
    const double share = light.samples / all.samples;
    if (path_class != other_class && is_unmet(light.met, share * of_each))
      unmet += std::max(share - light.states / all.states, 0.0);
  }
  const OfClass& other = classes[other_class];
  return std::max(unmet - std::max(other.states / all.states - other.samples / all.samples, 0.0),
                  0.0);
}

}  // namespace wander
