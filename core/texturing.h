// What a texture makes of a vertex.
//
// A material whose reflectance is a texture's is made with the reflectance 1, and what it says is
// scaled by the texel at the vertex: its value and tint, and its survival (by the texel's largest channel),
// which so is a matter of the vertex alone.  Densities of directions do not depend on a reflectance.
//
// Texture coordinates are found anew from the point, as shading normals are: paths hold nothing of
// them, and a scene without textures pays with the test of a pointer, one of the plane with nothing.
#pragma once

#include "core/path.h"
#include "core/scene.h"
#include "core/texture.h"

namespace wander {

template <World W>
class Texel {
 public:
  using Real = typename W::Real;

  Texel(const Scene<W>& scene, const Place<W>& place) {
    if constexpr (W::dimension == 3) {
      const Texture* texture = scene.surface(place.shape).texture;
      if (texture == nullptr) return;
      is_plain_ = false;
      read(*texture, scene.shape(place.shape), place);
    }
  }

  // A probability of survival.
  Real scaled(Real survival) const { return survival_of<W>(survival * luminance_, tint_); }
  Scattering<W> scaled(Scattering<W> s) const {
    if (is_plain_) return s;
    s.value *= luminance_;
    s.tint *= tint_;
    return s;
  }

 private:
  void read(const Texture& texture, const Shape<W>& shape, const Place<W>& place) {
    visit_shape(
        [&](const auto& s) {
          if constexpr (requires { s.texture_coordinates(place.position, place.primitive); }) {
            const auto colour = texture.at(s.texture_coordinates(place.position, place.primitive));
            luminance_ = static_cast<Real>(texture.is_coloured() ? luminance(colour) : colour[0]);
            if (texture.is_coloured()) tint_ = W::Tint::of(colour);
          }
        },
        shape);
  }

  bool is_plain_ = true;
  Real luminance_ = 1;
  [[no_unique_address]] typename W::Tint tint_{};
};

}  // namespace wander
