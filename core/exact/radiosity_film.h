// The film of a sensor, from the radiances that were found on a mesh: irradiance is gathered afresh
// at every point of the film, and integrated over each bin by an adaptive rule.
#pragma once

#include <cstddef>
#include <vector>

#include "core/exact/radiosity.h"
#include "core/exact/radiosity_mesh.h"
#include "core/exact/radiosity_series.h"
#include "core/exact/radiosity_transport.h"

namespace wander::exact {

class FilmIntegral {
 public:
  FilmIntegral(const RadiosityScene& scene, const Mesher& mesher, const Transport& transport,
               const Series& series)
      : scene_(scene), mesher_(mesher), transport_(transport), series_(series) {}

  // Stretches of bins are bisected so often at least.
  SensorFilm film_of(std::size_t wall, int least_depth) const;

 private:
  using Orders = std::vector<double>;  // one value per number of vertices, from 2
  struct BinIntegral {
    std::size_t wall;
    double tolerance;  // of the integral over [0, 1] of the wall
    int least_depth;
  };

  Orders gauss(std::size_t wall, Stretch stretch) const;
  Orders refined(const BinIntegral& bin, Stretch stretch, const Orders& estimate, int depth) const;

  const RadiosityScene& scene_;
  const Mesher& mesher_;
  const Transport& transport_;
  const Series& series_;
};

}  // namespace wander::exact
