// The sensor slide: the sensor's end of a path moves a little along the sensor, and the rest of the
// path stays.
//
// For paths that end on a shape and whose vertex before it scatters or is the light.  Each
// coordinate u of the sensor, in [0,1), becomes one that is uniform in the window of those within
// reach, window(u) = min(1, u + reach) - max(0, u - reach).  With A the sensor's measure,
//   T(x→y) = 1/A Π 1/window(u_x)
// The edges of the sensor cut windows off, so T(x→y) and T(y→x) differ.  Measure: area product.
#pragma once

#include <algorithm>
#include <array>

#include "core/transport.h"
#include "mlt/join.h"
#include "mlt/mutation.h"
#include "mlt/traits.h"

namespace wander {

struct SensorSlide {
  static constexpr std::string_view name = "sensor_slide";
  double reach = 0.2;  // as a share of the sensor

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    const int end = x.size() - 1;
    return !space.is_camera(x[end]) && space.can_connect(x[end - 1]) ? 1 : 0;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    if (applicability(space, x) == 0) return Failure{Reason::not_reversible};
    const int end = x.size() - 1;
    auto u = space.end_parameter(x, end);
    for (auto& coordinate : u) {
      const Window window = window_of(coordinate);
      coordinate = static_cast<typename Space::Real>(window.low + window.size() * random.uniform());
      if (!(coordinate < 1)) return Failure{Reason::outside_range};
    }
    y.resize(x.size());
    y.copy(x, 0, x.size(), 0);
    space.move_end(y, end, u);
    if (space.connect(y, end - 1) != Connection::open) return Failure{Reason::occluded};
    const Reason flaw = evaluate(space, y, end - 1, end);
    if (flaw != Reason::none) return Failure{flaw};
    return Proposal{density_from(space, x), density_from(space, y)};
  }

  struct Window {
    double low, high;
    double size() const { return high - low; }
  };
  Window window_of(double u) const { return {std::max(0.0, u - reach), std::min(1.0, u + reach)}; }

 private:
  // T(z→·), the same wherever in the window it leads.
  template <class Space>
  Scaled density_from(const Space& space, const Path<typename Space::Universe>& z) const {
    Scaled density = space.end_density(z, z.size() - 1);
    for (const auto u : space.end_parameter(z, z.size() - 1)) density /= window_of(u).size();
    return density;
  }
};

inline constexpr std::array<Parameter<SensorSlide>, 1> sensor_slide_parameters{
    {{"reach", "how far the end moves, as a share of the sensor", 1,
      [](const SensorSlide& m) {
        return Ends{m.reach, m.reach};
      },
      [](SensorSlide& m, Ends ends) { m.reach = ends.largest; }}}};

template <>
inline constexpr Traits<SensorSlide> traits<SensorSlide>{.parameters = sensor_slide_parameters};

}  // namespace wander
