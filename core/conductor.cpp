// Conductors, smooth and rough: directions are those of a mirror and of GGX microfacets, and of each
// channel is reflected what Fresnel's formulae say.
#include <algorithm>
#include <cmath>

#include "core/material.h"

namespace wander {

// With a + i b = √((η + i k)² - sin² θ) [Born and Wolf, 14.2],
//   R⊥ = ((a - cos)² + b²) / ((a + cos)² + b²),
//   R∥ = R⊥ ((a cos - sin²)² + (b cos)²) / ((a cos + sin²)² + (b cos)²).
// Of a² and b², whose difference is small beside their sum, the smaller one is found by division.
template <std::floating_point T>
T fresnel_conductor(T cosine, T eta, T k) {
  const T squared_cosine = cosine * cosine, squared_sine = (1 - cosine) * (1 + cosine);
  if (!(squared_cosine > 0)) return 1;  // grazing
  const T real = (eta - 1) * (eta + 1) - k * k + squared_cosine, half_imaginary = eta * k;
  const T larger = (std::hypot(real, 2 * half_imaginary) + std::abs(real)) / 2;
  const T smaller = larger > 0 ? half_imaginary * half_imaginary / larger : 0;
  const T a = std::sqrt(real > 0 ? larger : smaller), squared_b = real > 0 ? smaller : larger;
  const auto square = [](T x) { return x * x; };
  const T perpendicular = (square(a - cosine) + squared_b) / (square(a + cosine) + squared_b);
  const T most = square(a * cosine + squared_sine) + squared_b * squared_cosine;
  if (!(most > 0)) return perpendicular;
  const T least = square(a * cosine - squared_sine) + squared_b * squared_cosine;
  return perpendicular * (1 + least / most) / 2;
}

template <World W>
ComplexIndex<W>::ComplexIndex(const Constants& eta, const Constants& k)
    : eta_(eta), k_(k) {
  const Reflected along = reflected(1);
  survival_ = std::max(survival_of<W>(along.value, along.tint), static_cast<Real>(least_survival));
}

template <World W>
auto ComplexIndex<W>::reflected(typename W::Length cosine) const -> Reflected {
  using Length = typename W::Length;
  std::array<double, W::channels> share{};
  for (std::size_t i = 0; i < share.size(); ++i)
    share[i] = static_cast<double>(
        fresnel_conductor(cosine, static_cast<Length>(eta_[i]), static_cast<Length>(k_[i])));
  if constexpr (W::channels == 1)
    return {static_cast<Real>(share[0])};
  else
    return {static_cast<Real>(luminance(share)), W::Tint::of(share)};
}

template <World W>
Scattering<W> Conductor<W>::evaluate(Event event, Local to_light, Local to_sensor) const {
  Scattering<W> s = Mirror<W>{1}.evaluate(event, to_light, to_sensor);
  if (!(s.value > 0)) return s;
  const auto reflected = index.reflected(std::abs(W::Dimension::cosine(to_light)));
  s.value = reflected.value;
  s.tint = reflected.tint;
  return s;
}

// Of unit vectors with the half vector h, to_light · h = |to_light + to_sensor| / 2.
template <World W>
Scattering<W> RoughMetal<W>::evaluate(Event event, Local to_light, Local to_sensor) const {
  Scattering<W> s = RoughConductor<W>{roughness, 1}.evaluate(event, to_light, to_sensor);
  if (!(s.value > 0)) return s;
  const auto cosine = glm::length(to_light + to_sensor) / 2;
  const auto reflected = index.reflected(std::min(cosine, decltype(cosine)(1)));
  s.value *= reflected.value;
  s.tint = reflected.tint;
  return s;
}

#define WANDER_CONDUCTORS(World)      \
  template class ComplexIndex<World>; \
  template struct Conductor<World>;   \
  template struct RoughMetal<World>;
WANDER_CONDUCTORS(Flatland)
WANDER_CONDUCTORS(FlatlandSingle)
WANDER_CONDUCTORS(Spaceland)
WANDER_CONDUCTORS(SpacelandColour)
#undef WANDER_CONDUCTORS

template double fresnel_conductor(double, double, double);

}  // namespace wander
