// Scattering at a surface.  Directions are local (normal last) and point away from the surface;
// what is made of them is rounded to `Real` at the end, where that is less.
//
// All values and densities are with respect to *projected angle* dσ⊥ = |cos θ| dω, so a density of
// directions times the geometry term G is a density of area, and where a direction is sampled in
// proportion to the cosine nothing has to be divided by it.
//   value          f_s(light → sensor)     [Veach 1997, ch. 5: not symmetric in glass]; of colours
//                  luminance, and `tint` is what they are beside it (tint.h)
//   toward_sensor  density of sampling the sensor's direction, given the light's
//   toward_light   density of sampling the light's direction, given the sensor's
// For specular events all three are coefficients of one formal δ, of a reflection with ∫ δ dσ⊥ = 1, of a refraction with
// ∫ δ n^(D-1) dσ⊥ = 1 on either side of the surface (n: index of refraction there); it cancels in every ratio, and étendue
// n^(D-1) dσ⊥ is conserved by refraction, so the coefficients of both directions are consistent.
//
// Every material offers
//   evaluate(event, to_light, to_sensor)
//   sample(known, u)          a direction and an event, given the known direction
//   invert(known, sampled)    the numbers that sample that direction
//   survival()                probability that a walk goes on here under Russian roulette (survival_of)
// and the specular ones
//   follow(known, event)      the one direction of that event; none under total internal reflection
//   follow_density(followed, event)  the coefficient of δ for following it with probability one
#pragma once

#include <algorithm>
#include <optional>
#include <variant>

#include "core/complex_index.h"
#include "core/event.h"
#include "core/world.h"

namespace wander {

template <World W>
struct Scattering {
  using Real = typename W::Real;
  Real value = 0, toward_sensor = 0, toward_light = 0;
  [[no_unique_address]] typename W::Tint tint{};
};

// The random numbers that one scattering consumes.
template <World W>
struct ScatterNumbers {
  typename W::Square direction{};
  typename W::Real lobe = 0;
};

template <World W>
struct ScatterSample {
  typename W::Local direction;
  Event event;
};

// Numbers that sample a given direction.  What is not fixed by it lies in an interval: `lobe` is
// uniform in [lobe_low, lobe_high), and a direction with `direction_is_free` needs any number.
template <World W>
struct InvertedNumbers {
  typename W::Square direction{};
  typename W::Real lobe_low = 0, lobe_high = 1;
  bool direction_is_free = false;
};

// Does light on these two sides of the surface stay on one side of it?
template <World W>
bool same_side(typename W::Local a, typename W::Local b) {
  return W::Dimension::cosine(a) * W::Dimension::cosine(b) > 0;
}

// The largest channel of what a surface reflects: with this probability a walk survives it.  What survives so
// weighs no more than before in any channel; by luminance the second moment of red would grow by the factor
// ρ_red / luminance(ρ), up to 4.7, at each bounce, and that of blue up to 13.85.
template <World W>
typename W::Real survival_of(typename W::Real reflected, const typename W::Tint& tint) {
  return std::min(reflected * static_cast<typename W::Real>(tint.largest()), typename W::Real(1));
}

template <World W>
struct Black {
  using Local = typename W::Local;
  Scattering<W> evaluate(Event, Local, Local) const { return {}; }
  std::optional<ScatterSample<W>> sample(Local, ScatterNumbers<W>) const { return {}; }
  InvertedNumbers<W> invert(Local, Local, Event) const { return {}; }
  typename W::Real survival() const { return 0; }
  static constexpr bool specular = false, has_lobes = false, scatters = false;
};

// Lambert: f = ρ / c with c = ∫ cos θ dω; both sides.
template <World W>
struct Diffuse {
  using Real = typename W::Real;
  using Local = typename W::Local;
  Real reflectance;
  [[no_unique_address]] typename W::Tint tint{};

  Scattering<W> evaluate(Event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const;
  InvertedNumbers<W> invert(Local known, Local sampled, Event) const;
  Real survival() const { return survival_of<W>(reflectance, tint); }
  static constexpr bool specular = false, has_lobes = false, scatters = true;
};

template <World W>
struct Mirror {
  using Real = typename W::Real;
  using Local = typename W::Local;
  Real reflectance;
  [[no_unique_address]] typename W::Tint tint{};

  Scattering<W> evaluate(Event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const;
  InvertedNumbers<W> invert(Local known, Local sampled, Event) const;
  std::optional<Local> follow(Local known, Event event) const;
  Real follow_density(Local, Event) const { return 1; }
  Real survival() const { return survival_of<W>(reflectance, tint); }
  static constexpr bool specular = true, has_lobes = false, scatters = true;
};

// A smooth interface; the inside is behind the normal.  Fresnel: the unpolarised average.
template <World W>
struct Dielectric {
  using Real = typename W::Real;
  using Local = typename W::Local;
  Real interior, exterior;  // indices of refraction

  Scattering<W> evaluate(Event event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const;
  InvertedNumbers<W> invert(Local known, Local sampled, Event event) const;
  std::optional<Local> follow(Local known, Event event) const;
  Real follow_density(Local followed, Event event) const;
  Real survival() const { return 1; }
  static constexpr bool specular = true, has_lobes = true, scatters = true;
};

// GGX microfacets with a constant Fresnel factor, single scattering, height-correlated Smith
// masking G = 1/(1 + Λ(i) + Λ(o)); normals are sampled as visible from the known direction.
template <World W>
struct RoughConductor {
  using Real = typename W::Real;
  using Local = typename W::Local;
  Real roughness, reflectance;
  [[no_unique_address]] typename W::Tint tint{};

  Scattering<W> evaluate(Event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const;
  InvertedNumbers<W> invert(Local known, Local sampled, Event) const;
  Real survival() const { return survival_of<W>(reflectance, tint); }
  static constexpr bool specular = false, has_lobes = false, scatters = true;
};

// A mirror that reflects as Fresnel's formulae say.  A walk survives with the share that is reflected
// along the normal, which is about the least of all directions: the share of the direction at hand
// would depend on the end that the walk comes from.
template <World W>
struct Conductor {
  using Real = typename W::Real;
  using Local = typename W::Local;
  ComplexIndex<W> index;

  Scattering<W> evaluate(Event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const {
    return Mirror<W>{1}.sample(known, u);
  }
  InvertedNumbers<W> invert(Local known, Local sampled, Event event) const {
    return Mirror<W>{1}.invert(known, sampled, event);
  }
  std::optional<Local> follow(Local known, Event event) const {
    return Mirror<W>{1}.follow(known, event);
  }
  Real follow_density(Local, Event) const { return 1; }
  Real survival() const { return index.survival(); }
  static constexpr bool specular = true, has_lobes = false, scatters = true;
};

// GGX microfacets that reflect so, each by the angle to its own normal.
template <World W>
struct RoughMetal {
  using Real = typename W::Real;
  using Local = typename W::Local;
  Real roughness;
  ComplexIndex<W> index;

  Scattering<W> evaluate(Event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const {
    return RoughConductor<W>{roughness, 1}.sample(known, u);
  }
  InvertedNumbers<W> invert(Local known, Local sampled, Event event) const {
    return RoughConductor<W>{roughness, 1}.invert(known, sampled, event);
  }
  Real survival() const { return index.survival(); }
  static constexpr bool specular = false, has_lobes = false, scatters = true;
};

// GGX microfacets of glass (Walter et al. 2007, in either dimension).
template <World W>
struct RoughDielectric {
  using Real = typename W::Real;
  using Local = typename W::Local;
  Real roughness, interior, exterior;

  Scattering<W> evaluate(Event, Local to_light, Local to_sensor) const;
  std::optional<ScatterSample<W>> sample(Local known, ScatterNumbers<W> u) const;
  InvertedNumbers<W> invert(Local known, Local sampled, Event) const;
  Real survival() const { return 1; }
  static constexpr bool specular = false, has_lobes = true, scatters = true;
};

template <World W>
using Material = std::variant<Diffuse<W>, Black<W>, Mirror<W>, Dielectric<W>, RoughConductor<W>,
                              RoughDielectric<W>, Conductor<W>, RoughMetal<W>>;

// Fresnel reflectance of unpolarised light, the mean of both polarisations.  `cosine` > 0 on the
// side of index n_incident; total internal reflection gives 1.
template <std::floating_point T>
T fresnel(T cosine, T n_incident, T n_transmitted);

}  // namespace wander
