// The index of refraction η + i k of a conductor, beside that of what is outside it: one for each
// channel of colour.
#pragma once

#include "core/world.h"

namespace wander {

// Fresnel reflectance of unpolarised light, the mean of both polarisations; `cosine` > 0.
template <std::floating_point T>
T fresnel_conductor(T cosine, T eta, T k);

template <World W>
class ComplexIndex {
 public:
  using Real = typename W::Real;
  using Constants = std::array<Real, W::channels>;

  ComplexIndex(const Constants& eta, const Constants& k);

  // Luminance, and what colour adds to it (tint.h).
  struct Reflected {
    Real value = 0;
    [[no_unique_address]] typename W::Tint tint{};
  };
  Reflected reflected(typename W::Length cosine) const;
  // Under roulette a walk survives with the share of light that is reflected along the normal, of the channel that
  // reflects most, or with a half if that is more: at grazing angles all light is, and what survives is weighed no more
  // than twice.
  static constexpr double least_survival = 0.5;
  Real survival() const { return survival_; }

 private:
  Constants eta_, k_;
  Real survival_;
};

}  // namespace wander
