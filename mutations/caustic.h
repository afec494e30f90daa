// The caustic perturbation [Veach and Guibas 1997, 5.3.2; Veach 1997, 11.4]: the lens
// perturbation seen from the other end.
//
// For paths … a S* d E: the direction at a, the last vertex but d that is not specular, turns
// towards the sensor, the specular chain S* is followed to d, and d is connected to the sensor's
// end.  Where light falls on the sensor from a specular surface, … a S+ E, the walk itself must hit
// the sensor; a camera cannot be hit.  Where a is the light, its point moves too.
#pragma once

#include <optional>

#include "core/requirements.h"
#include "mutations/perturbation.h"

namespace wander {

struct Caustic {
  static constexpr std::string_view name = "caustic";
  PerturbationRange range{};

  static std::string_view left_out(const Requirements& scene) {
    if (scene.caustic_paths_possible || scene.glossy) return {};
    return "no smooth or rough mirror or glass focuses light on a surface that scatters or listens";
  }

  template <class Space>
  double applicability(const Space& space, const Path<typename Space::Universe>& x) const {
    return stretch(space, x) ? 1 : 0;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const auto moved = stretch(space, x);
    if (!moved) return Failure{Reason::not_reversible};
    return Perturbation<Space>(space, range, x, y, *moved).propose(random);
  }

 private:
  // a S* d, or a S* E; a matter of the path's class alone.
  template <class Space, class W>
  static std::optional<Stretch> stretch(const Space& space, const Path<W>& x) {
    const int end = x.size() - 1;
    const bool hits_sensor = end == 1 || is_specular(x[end - 1].event);
    if (hits_sensor && !space.sensor_can_be_hit()) return {};
    const int last = hits_sensor ? end : end - 1;
    return Stretch{Toward::sensor, next_not_specular(x, last, Toward::light), last};
  }
};

template <>
inline constexpr Traits<Caustic> traits<Caustic>{
    .left_out = Caustic::left_out,
    .scaled = [](const Caustic& m, double factor) { return Caustic{m.range.scaled(factor)}; },
    .parameters = perturbation_parameters<Caustic>};

}  // namespace wander
