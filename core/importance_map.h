// A factor v on what a sensor or a camera measures, constant on blocks of its film: the second stage of two-stage Metropolis
// light transport [Veach and Guibas 1997], in which the target of chains is f / I, with the light I of a test image.
//
// A space with a map measures f v in place of f, with We v in place of We: of the area product, as f is.
// Its samples find the same paths with the same densities.  What one finds of f v, or a chain whose target is f v
// deposits, shows 1/v times as much light.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/raster.h"

namespace wander {

// Of one bin: how much is measured where there is light of one, and how much light a measure of one shows.
struct Importance {
  double v = 1, light_of_measure = 1;
  bool operator==(const Importance&) const = default;
};

class ImportanceMap {
 public:
  // `factors`: of the cells.
  ImportanceMap(Raster raster, const std::vector<double>& factors) : raster_(std::move(raster)) {
    for (const double v : factors) cells_.push_back({v, 1 / v});
  }

  const Importance& operator()(int bin) const { return cells_[raster_.cell(bin)]; }

 private:
  Raster raster_;
  std::vector<Importance> cells_;
};

// Of this bin; in spaces that know no map it is one.
template <class Space>
Importance importance(const Space& space, int bin) {
  if constexpr (requires { space.importance(bin); })
    return space.importance(bin);
  else
    return {};
}
template <class Space>
double light_of_measure(const Space& space, int bin) {
  return importance(space, bin).light_of_measure;
}

// The same paths, of which light is measured, whether there is a map or none.
template <class Space>
Space measuring_light(const Space& space) {
  if constexpr (requires { space.measuring_light(); })
    return space.measuring_light();
  else
    return space;
}

}  // namespace wander
