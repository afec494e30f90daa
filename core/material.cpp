#include "core/material.h"

#include <cmath>

namespace wander {

namespace {

// With w the local direction on the side of index n_w, the direction across the interface, or none
// under total internal reflection.  `h` is the normal on the side of w.
template <World W>
std::optional<typename W::Local> refract(typename W::Local w, typename W::Local h,
                                         typename W::Length n_w, typename W::Length n_across) {
  using Length = typename W::Length;
  const Length eta = n_w / n_across, cosine = glm::dot(w, h);
  const auto along = w - cosine * h;
  const Length squared_sine = eta * eta * glm::dot(along, along);
  if (squared_sine >= 1) return {};
  return glm::normalize(-eta * along - std::sqrt(1 - squared_sine) * h);
}

template <World W>
typename W::Local mirrored(typename W::Local w) {
  w = -w;
  w[W::dimension - 1] = -w[W::dimension - 1];
  return w;
}

template <World W>
typename W::Local upward(typename W::Local h) {
  return W::Dimension::cosine(h) < 0 ? -h : h;
}

// Index of refraction on the side of w.
template <World W, class M>
typename W::Length index_at(const M& glass, typename W::Local w) {
  return W::Dimension::cosine(w) > 0 ? glass.exterior : glass.interior;
}
template <World W, class M>
typename W::Length index_across(const M& glass, typename W::Local w) {
  return W::Dimension::cosine(w) > 0 ? glass.interior : glass.exterior;
}

// A direction as densities take it: every component keeps the precision that `Real` has.
template <World W>
auto rounded(typename W::Local w) {
  return Vec<W::dimension, typename W::Real>(w);
}

// And back: of unit length in the precision of angles.
template <World W>
typename W::Local exact_unit(Vec<W::dimension, typename W::Real> w) {
  if constexpr (std::same_as<typename W::Real, typename W::Length>)
    return w;
  else
    return glm::normalize(typename W::Local(w));
}

// Smith: Λ = (-1 + sqrt(1 + α² tan² θ)) / 2 for GGX, in both dimensions.
template <World W>
typename W::Real smith_lambda(typename W::Real alpha, typename W::Local w) {
  using Length = typename W::Length;
  const Length cosine = W::Dimension::cosine(w);
  const Length a = alpha * alpha * W::Dimension::squared_sine(w) / (cosine * cosine);
  return static_cast<typename W::Real>(a / (2 * (1 + std::sqrt(1 + a))));
}

// Normals visible from `known`, on its side of the surface.
template <World W>
typename W::Local visible_normal(typename W::Real alpha, typename W::Local known,
                                 typename W::Square u) {
  const typename W::Local h = exact_unit<W>(W::Dimension::visible_normal_sample(
      alpha, rounded<W>(W::Dimension::cosine(known) < 0 ? -known : known), u));
  return W::Dimension::cosine(known) < 0 ? -h : h;
}
template <World W>
typename W::Square visible_normal_numbers(typename W::Real alpha, typename W::Local known,
                                          typename W::Local h) {
  auto u = W::Dimension::visible_normal_invert(
      alpha, rounded<W>(W::Dimension::cosine(known) < 0 ? -known : known),
      rounded<W>(upward<W>(h)));
  for (auto& x : u) x = into_unit<typename W::Real>(x);
  return u;
}

// The terms of a microfacet model that do not depend on what happens at the facet.
template <World W>
struct Facets {
  using Real = typename W::Real;
  Real density;  // D(h)
  Real lambda_light, lambda_sensor;
  Real cosines;            // |cos θ_light cos θ_sensor|
  Real light_h, sensor_h;  // |ω·h|

  Facets(Real alpha, typename W::Local h, typename W::Local to_light, typename W::Local to_sensor)
      : density(W::Dimension::ggx(alpha, rounded<W>(h))),
        lambda_light(smith_lambda<W>(alpha, to_light)),
        lambda_sensor(smith_lambda<W>(alpha, to_sensor)),
        cosines(static_cast<Real>(
            std::abs(W::Dimension::cosine(to_light) * W::Dimension::cosine(to_sensor)))),
        light_h(static_cast<Real>(std::abs(glm::dot(to_light, h)))),
        sensor_h(static_cast<Real>(std::abs(glm::dot(to_sensor, h)))) {}

  Real masking() const { return 1 / (1 + lambda_light + lambda_sensor); }
  Real visible_from_light() const { return 1 / (1 + lambda_light); }
  Real visible_from_sensor() const { return 1 / (1 + lambda_sensor); }
};

// D G |i·h| ∂ω_h/∂ω_o / (|cos θ_i cos θ_o|), and with G1 in place of G the density of sampling.
template <World W>
Scattering<W> reflect_at_facets(const Facets<W>& facets, typename W::Real probability) {
  const auto common = probability * facets.density * facets.light_h *
                      W::Dimension::reflection(facets.light_h) / facets.cosines;
  return {common * facets.masking(), common * facets.visible_from_light(),
          common * facets.visible_from_sensor()};
}

template <World W>
typename W::Local half_vector(typename W::Local a, typename W::Local b) {
  return upward<W>(glm::normalize(a + b));
}

}  // namespace

template <std::floating_point T>
T fresnel(T cosine, T n_incident, T n_transmitted) {
  const T eta = n_incident / n_transmitted;
  // cos² across = 1 - η² sin², written so that equal indices leave the cosine as it is.
  const T squared_cosine = (1 - eta) * (1 + eta) + eta * eta * cosine * cosine;
  if (!(squared_cosine > 0)) return 1;
  const T across = std::sqrt(squared_cosine);
  const T parallel = (cosine - eta * across) / (cosine + eta * across);
  const T perpendicular = (eta * cosine - across) / (eta * cosine + across);
  return (parallel * parallel + perpendicular * perpendicular) / 2;
}

// ---- diffuse ------------------------------------------------------------------------------------

template <World W>
Scattering<W> Diffuse<W>::evaluate(Event, Local to_light, Local to_sensor) const {
  if (!same_side<W>(to_light, to_sensor)) return {};
  constexpr Real c = W::Dimension::template half_space<Real>;
  return {reflectance / c, 1 / c, 1 / c, tint};
}

template <World W>
std::optional<ScatterSample<W>> Diffuse<W>::sample(Local known, ScatterNumbers<W> u) const {
  Local sampled(W::Dimension::cosine_sample(u.direction));
  if (W::Dimension::cosine(known) < 0) sampled[W::dimension - 1] = -sampled[W::dimension - 1];
  return ScatterSample<W>{sampled, Event::scattering};
}

template <World W>
InvertedNumbers<W> Diffuse<W>::invert(Local, Local sampled, Event) const {
  InvertedNumbers<W> numbers{.direction = W::Dimension::cosine_invert(rounded<W>(sampled))};
  for (auto& x : numbers.direction) x = into_unit<Real>(x);
  return numbers;
}

// ---- mirror -------------------------------------------------------------------------------------

template <World W>
Scattering<W> Mirror<W>::evaluate(Event, Local to_light, Local to_sensor) const {
  if (!same_side<W>(to_light, to_sensor)) return {};
  return {reflectance, 1, 1, tint};
}

template <World W>
std::optional<ScatterSample<W>> Mirror<W>::sample(Local known, ScatterNumbers<W>) const {
  return ScatterSample<W>{mirrored<W>(known), Event::reflection};
}

template <World W>
InvertedNumbers<W> Mirror<W>::invert(Local, Local, Event) const {
  return {.direction_is_free = true};
}

template <World W>
auto Mirror<W>::follow(Local known, Event event) const -> std::optional<Local> {
  if (event != Event::reflection) return {};
  return mirrored<W>(known);
}

// ---- dielectric ---------------------------------------------------------------------------------

template <World W>
Scattering<W> Dielectric<W>::evaluate(Event event, Local to_light, Local to_sensor) const {
  const bool reflects = same_side<W>(to_light, to_sensor);
  if (reflects != (event == Event::reflection)) return {};
  const auto n_light = index_at<W>(*this, to_light), n_across = index_across<W>(*this, to_light);
  const auto f = fresnel(std::abs(W::Dimension::cosine(to_light)), n_light, n_across);
  const auto reflected = static_cast<Real>(f), transmitted = static_cast<Real>(1 - f);
  if (reflects) return {reflected, reflected, reflected};
  const auto to_sensor_spread = static_cast<Real>(W::Dimension::index_spread(n_across));
  const auto to_light_spread = static_cast<Real>(W::Dimension::index_spread(n_light));
  return {transmitted * to_sensor_spread, transmitted * to_sensor_spread,
          transmitted * to_light_spread};
}

template <World W>
auto Dielectric<W>::follow(Local known, Event event) const -> std::optional<Local> {
  if (event == Event::reflection) return mirrored<W>(known);
  Local normal(0);
  normal[W::dimension - 1] = std::copysign(typename W::Length(1), W::Dimension::cosine(known));
  return refract<W>(known, normal, index_at<W>(*this, known), index_across<W>(*this, known));
}

template <World W>
auto Dielectric<W>::follow_density(Local followed, Event event) const -> Real {
  if (event == Event::reflection) return 1;
  return static_cast<Real>(W::Dimension::index_spread(index_at<W>(*this, followed)));
}

template <World W>
std::optional<ScatterSample<W>> Dielectric<W>::sample(Local known, ScatterNumbers<W> u) const {
  const auto f = fresnel(std::abs(W::Dimension::cosine(known)), index_at<W>(*this, known),
                         index_across<W>(*this, known));
  const Event event = u.lobe < f ? Event::reflection : Event::transmission;
  const auto direction = follow(known, event);
  if (!direction) return {};
  return ScatterSample<W>{*direction, event};
}

template <World W>
InvertedNumbers<W> Dielectric<W>::invert(Local known, Local, Event event) const {
  const auto f =
      static_cast<Real>(fresnel(std::abs(W::Dimension::cosine(known)), index_at<W>(*this, known),
                                index_across<W>(*this, known)));
  const bool reflects = event == Event::reflection;
  return {.lobe_low = reflects ? 0 : f, .lobe_high = reflects ? f : 1, .direction_is_free = true};
}

// ---- rough conductor ----------------------------------------------------------------------------

template <World W>
Scattering<W> RoughConductor<W>::evaluate(Event, Local to_light, Local to_sensor) const {
  if (!same_side<W>(to_light, to_sensor)) return {};
  const Facets<W> facets(roughness, half_vector<W>(to_light, to_sensor), to_light, to_sensor);
  Scattering<W> s = reflect_at_facets(facets, Real(1));
  s.value *= reflectance;
  s.tint = tint;
  return s;
}

template <World W>
std::optional<ScatterSample<W>> RoughConductor<W>::sample(Local known, ScatterNumbers<W> u) const {
  const Local h = visible_normal<W>(roughness, known, u.direction);
  const Local sampled = glm::normalize(2 * glm::dot(known, h) * h - known);
  if (!same_side<W>(known, sampled)) return {};  // a second bounce among the facets: not modelled
  return ScatterSample<W>{sampled, Event::scattering};
}

template <World W>
InvertedNumbers<W> RoughConductor<W>::invert(Local known, Local sampled, Event) const {
  return {.direction = visible_normal_numbers<W>(roughness, known, half_vector<W>(known, sampled))};
}

// ---- rough dielectric ---------------------------------------------------------------------------

namespace {

// Walter et al. 2007, eq. 16: the facet that refracts a into b, on the upper side.  None when the
// indices match and the directions oppose each other, or when no facet does.
template <World W, class M>
std::optional<typename W::Local> refracting_facet(const M& glass, typename W::Local a,
                                                  typename W::Local b) {
  const auto sum = index_at<W>(glass, a) * a + index_at<W>(glass, b) * b;
  const auto length = glm::length(sum);
  if (!(length > 0)) return {};
  const auto h = upward<W>(sum / length);
  if (glm::dot(a, h) * W::Dimension::cosine(a) <= 0) return {};
  if (glm::dot(b, h) * W::Dimension::cosine(b) <= 0) return {};
  return h;
}

}  // namespace

template <World W>
Scattering<W> RoughDielectric<W>::evaluate(Event, Local to_light, Local to_sensor) const {
  const auto n_light = index_at<W>(*this, to_light), n_sensor = index_at<W>(*this, to_sensor);
  const auto n_across = index_across<W>(*this, to_light);
  if (same_side<W>(to_light, to_sensor)) {
    const Local h = half_vector<W>(to_light, to_sensor);
    const Facets<W> facets(roughness, h, to_light, to_sensor);
    const auto f = fresnel(std::abs(glm::dot(to_light, h)), n_light, n_across);
    return reflect_at_facets(facets, static_cast<Real>(f));
  }
  const auto h = refracting_facet<W>(*this, to_light, to_sensor);
  if (!h) return {};
  const Facets<W> facets(roughness, *h, to_light, to_sensor);
  // ∂ω_h/∂ω_o = (n_o / |n_i i + n_o o|)^(D-1) |o·h|
  const auto sum = glm::length(n_light * to_light + n_sensor * to_sensor);
  const auto f = fresnel(std::abs(glm::dot(to_light, *h)), n_light, n_across);
  const Real common =
      static_cast<Real>(1 - f) * facets.density * facets.light_h * facets.sensor_h / facets.cosines;
  const auto to_sensor_spread = static_cast<Real>(W::Dimension::index_spread(n_sensor / sum));
  const auto to_light_spread = static_cast<Real>(W::Dimension::index_spread(n_light / sum));
  return {common * to_sensor_spread * facets.masking(),
          common * to_sensor_spread * facets.visible_from_light(),
          common * to_light_spread * facets.visible_from_sensor()};
}

template <World W>
std::optional<ScatterSample<W>> RoughDielectric<W>::sample(Local known, ScatterNumbers<W> u) const {
  const Local h = visible_normal<W>(roughness, known, u.direction);
  const auto n_known = index_at<W>(*this, known), n_across = index_across<W>(*this, known);
  const auto cosine = glm::dot(known, h);
  if (!(cosine > 0)) return {};
  if (u.lobe < fresnel(cosine, n_known, n_across)) {
    const Local reflected = glm::normalize(2 * cosine * h - known);
    if (!same_side<W>(known, reflected)) return {};
    return ScatterSample<W>{reflected, Event::scattering};
  }
  const auto across = refract<W>(known, h, n_known, n_across);
  if (!across || same_side<W>(known, *across)) return {};
  return ScatterSample<W>{*across, Event::scattering};
}

template <World W>
InvertedNumbers<W> RoughDielectric<W>::invert(Local known, Local sampled, Event) const {
  const bool reflects = same_side<W>(known, sampled);
  const Local h = reflects ? half_vector<W>(known, sampled)
                           : refracting_facet<W>(*this, known, sampled).value_or(upward<W>(known));
  const auto f = static_cast<Real>(fresnel(std::abs(glm::dot(known, h)), index_at<W>(*this, known),
                                           index_across<W>(*this, known)));
  return {.direction = visible_normal_numbers<W>(roughness, known, h),
          .lobe_low = reflects ? 0 : f,
          .lobe_high = reflects ? f : 1};
}

#define WANDER_MATERIALS(World)          \
  template struct Diffuse<World>;        \
  template struct Mirror<World>;         \
  template struct Dielectric<World>;     \
  template struct RoughConductor<World>; \
  template struct RoughDielectric<World>;
WANDER_MATERIALS(Flatland)
WANDER_MATERIALS(FlatlandSingle)
WANDER_MATERIALS(Spaceland)
WANDER_MATERIALS(SpacelandColour)
#undef WANDER_MATERIALS

template double fresnel(double, double, double);

}  // namespace wander
