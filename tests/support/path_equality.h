// Paths that are the same bit for bit.
#pragma once

#include <gtest/gtest.h>

#include "core/path.h"

namespace wander::test {

inline bool same_tint(Tint<1>, Tint<1>) { return true; }
inline bool same_tint(const Tint<3>& a, const Tint<3>& b) { return a.colour == b.colour; }

template <class W>
bool identical(const Vertex<W>& a, const Vertex<W>& b) {
  return a.place.position == b.place.position && a.place.normal == b.place.normal &&
         a.place.to_sensor == b.place.to_sensor && a.place.element() == b.place.element() &&
         a.geometry == b.geometry && a.value == b.value && a.from_light == b.from_light &&
         a.from_sensor == b.from_sensor && a.event == b.event && same_tint(a.tint, b.tint);
}

// `to_sensor` and `geometry` of the last vertex belong to no edge.
template <class W>
::testing::AssertionResult identical(const Path<W>& a, const Path<W>& b) {
  if (a.size() != b.size())
    return ::testing::AssertionFailure() << a.size() << " and " << b.size() << " vertices";
  for (int i = 0; i < a.size(); ++i) {
    Vertex<W> u = a[i], v = b[i];
    if (i + 1 == a.size()) {
      u.place.to_sensor = v.place.to_sensor = {};
      u.geometry = v.geometry = 0;
    }
    if (!identical(u, v)) return ::testing::AssertionFailure() << "they differ at vertex " << i;
  }
  if (!(a.contribution == b.contribution && a.intensity == b.intensity &&
        a.intensity_under_roulette == b.intensity_under_roulette))
    return ::testing::AssertionFailure() << "their contributions or intensities differ";
  if (a.weights() != b.weights()) return ::testing::AssertionFailure() << "their weights differ";
  return ::testing::AssertionSuccess();
}

}  // namespace wander::test
