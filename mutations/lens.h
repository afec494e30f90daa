// The lens perturbation [Veach and Guibas 1997, 5.3.2; Veach 1997, 11.4].
//
// For paths … z d S* E: the sensor's end moves (its point on a finite sensor or lens, and its
// direction, or the point of a camera's film), the specular chain S* is followed to the first
// vertex d that scatters, and d is connected to z, which must scatter too.  Where d is the light
// itself, there is nothing to connect.
#pragma once

#include <optional>

#include "mutations/perturbation.h"

namespace wander {

struct Lens {
  static constexpr std::string_view name = "lens";
  PerturbationRange range{};

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
  // E S* d; it is a matter of the path's class alone, so x and y agree on it.
  template <class W>
  static std::optional<Stretch> stretch(const Path<W>& x) {
    const int end = x.size() - 1, d = next_not_specular(x, end, Toward::light);
    if (d > 0 && is_specular(x[d - 1].event)) return {};
    return Stretch{Toward::light, end, d};
  }
};

template <>
inline constexpr Traits<Lens> traits<Lens>{
    .scaled = [](const Lens& m, double factor) { return Lens{m.range.scaled(factor)}; },
    .parameters = perturbation_parameters<Lens>};

}  // namespace wander
