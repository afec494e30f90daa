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

class ImportanceMap {
 public:
  // `factors`: of the cells.
  ImportanceMap(Raster raster, std::vector<double> factors)
      : raster_(std::move(raster)), factors_(std::move(factors)) {
    for (const double v : factors_) light_.push_back(1 / v);
  }

  double operator()(int bin) const { return factors_[raster_.cell(bin)]; }
  double light_of_measure(int bin) const { return light_[raster_.cell(bin)]; }  // 1/v

 private:
  Raster raster_;
  std::vector<double> factors_, light_;
};

// How much light a measure of one on this bin shows, 1/v; in spaces that know no map it is one.
template <class Space>
double light_of_measure(const Space& space, int bin) {
  if constexpr (requires { space.light_of_measure(bin); })
    return space.light_of_measure(bin);
  else
    return 1;
}

}  // namespace wander
