// Closing a proposed path: the edge between its two subpaths, or the end that one of them has hit.
#pragma once

#include "core/transport.h"
#include "mlt/proposal.h"

namespace wander {

// y holds s vertices sampled from the light and n - s from the sensor.  Writes the edge between
// them and the events of its ends; what is measured at the vertices is left to the caller.
template <class Space>
Reason join(const Space& space, Path<typename Space::Universe>& y, int s) {
  const int n = y.size();
  if (s == 0) {
    if (!space.is_light(y[0])) return Reason::zero_contribution;
    y[0].event = Event::emission;
    return Reason::none;
  }
  if (s == n) {
    if (!space.is_sensor(y[n - 1])) return Reason::zero_contribution;
    y[n - 1].event = Event::detection;
    return Reason::none;
  }
  if (!space.can_connect(y[s - 1]) || !space.can_connect(y[s])) return Reason::changed_class;
  return space.connect(y, s - 1) == Connection::open ? Reason::none : Reason::occluded;
}

// Measures the vertices first … last of y, whose neighbours are known; says whether light gets
// through.
template <class Space>
Reason evaluate(const Space& space, Path<typename Space::Universe>& y, int first, int last) {
  for (int i = first; i <= last; ++i) {
    space.evaluate(y, i);
    if (!(y[i].value > 0)) return y[i].value == 0 ? Reason::zero_contribution : Reason::not_finite;
  }
  return Reason::none;
}

}  // namespace wander
