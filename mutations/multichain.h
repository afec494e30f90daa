// The multi-chain perturbation [Veach and Guibas 1997, 5.3.2; Veach 1997, 11.4]: for paths on
// which specular chains follow each other, such as L S D S E.
//
// It starts as the lens perturbation does, E S* d; as long as the next vertex towards the light is
// specular, the direction at d turns too and the next chain is followed.  It ends at the first
// vertex that scatters and whose neighbour scatters, which are connected, or at the light.  Where
// the lens perturbation can act, this one cannot.
#pragma once

#include <optional>

#include "core/requirements.h"
#include "mutations/perturbation.h"

namespace wander {

struct Multichain {
  static constexpr std::string_view name = "multichain";
  PerturbationRange range{};

  static std::string_view left_out(const Requirements& scene) {
    if (scene.specular && scene.scatters && scene.max_vertices >= 4) return {};
    return "no path has a specular vertex behind one that scatters, as the sensor sees it";
  }

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>& x) const {
    return stretch(x) ? 1 : 0;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const auto moved = stretch(x);
    if (!moved) return Failure{Reason::not_reversible};
    return Perturbation<Space>(space, range, x, y, *moved).propose(random);
  }

 private:
  // E S* d (S+ d)+; a matter of the path's class alone.
  template <class W>
  static std::optional<Stretch> stretch(const Path<W>& x) {
    const int end = x.size() - 1;
    const int first_chain = next_not_specular(x, end, Toward::light);
    int d = first_chain;
    while (d > 0 && is_specular(x[d - 1].event)) d = next_not_specular(x, d, Toward::light);
    if (d == first_chain) return {};
    return Stretch{Toward::light, end, d};
  }
};

template <>
inline constexpr Traits<Multichain> traits<Multichain>{
    .left_out = Multichain::left_out,
    .scaled = [](const Multichain& m, double factor) { return Multichain{m.range.scaled(factor)}; },
    .parameters = perturbation_parameters<Multichain>};

}  // namespace wander
