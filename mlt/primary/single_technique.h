// One path of n vertices by one technique: s vertices sampled from the light, n - s from the
// sensor, and the edge between them.  Numbers are consumed at the places that a bidirectional
// sample gives the same vertices (core/random_place.h).
#pragma once

#include "core/random_place.h"
#include "core/techniques.h"
#include "mlt/join.h"

namespace wander {

template <class Space, class Random>
Reason sample_technique(const Space& space, Path<typename Space::Universe>& y, int n, int s,
                        Random& random) {
  y.resize(n);
  if (s > 0) {
    seek(random, {Subpath::light, 0});
    space.begin_light(y, 0, random);
  }
  for (int i = 0; i + 1 < s; ++i) {
    seek(random, {Subpath::light, i + 1});
    if (!space.extend(y, i, Toward::sensor, random)) return Reason::missed_scene;
  }
  if (s < n) {
    seek(random, {Subpath::sensor, 0});
    space.begin_sensor(y, n - 1, random);
  }
  for (int i = n - 1; i > s; --i) {
    seek(random, {Subpath::sensor, n - i});
    if (!space.extend(y, i, Toward::light, random)) return Reason::missed_scene;
  }
  const Reason flaw = join(space, y, s);
  return flaw == Reason::none ? evaluate(space, y, 0, n - 1) : flaw;
}

}  // namespace wander
