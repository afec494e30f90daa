#include "tests/support/mirror_image.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/support/quadrature.h"

namespace wander::test {

namespace {

// Sines of the angles from the receiver's normal; empty when high <= low.
struct Sines {
  double low, high;

  double size() const { return std::max(0.0, high - low); }
};

Sines intersection(Sines a, Sines b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

// The part of a segment above the receiver's horizon, as seen from there.
std::optional<Sines> sines_of(const PlaneSegment& s, const Receiver& receiver) {
  const double from = dot(s.from - receiver.position, receiver.normal);
  const double to = dot(s.to - receiver.position, receiver.normal);
  if (from <= 0 && to <= 0) return std::nullopt;
  const auto sine = [&](double position) {
    const PlanePoint d = s.at(position) - receiver.position;
    return -cross(receiver.normal, d) / length(d);
  };
  const double horizon = from / (from - to);
  const double a = sine(from < 0 ? horizon : 0), b = sine(to < 0 ? horizon : 1);
  return Sines{std::min(a, b), std::max(a, b)};
}

// p on the other side of the mirror's line.
PlanePoint reflect(PlanePoint p, const PlaneSegment& mirror) {
  const PlanePoint n = normal(mirror);
  return p - 2 * dot(p - mirror.from, n) * n;
}

bool is_in_front(PlanePoint p, const PlaneSegment& s) { return dot(p - s.from, normal(s)) > 0; }

constexpr Accuracy film_accuracy{.absolute = 1e-14, .depth = 40};

}  // namespace

double mirror_point_irradiance(const MirrorScene& scene, const Receiver& receiver) {
  // The emitter shines on the mirror, and the receiver, mirrored, must stand before its front.
  if (!is_in_front(reflect(receiver.position, scene.mirror), scene.emitter)) return 0;
  if (is_in_front(receiver.position, scene.mirror) !=
      is_in_front(scene.emitter.at(0.5), scene.mirror))
    return 0;
  const PlaneSegment image{reflect(scene.emitter.from, scene.mirror),
                           reflect(scene.emitter.to, scene.mirror)};
  const auto seen = sines_of(image, receiver), aperture = sines_of(scene.mirror, receiver);
  if (!seen || !aperture) return 0;
  const Sines lit = intersection(*seen, *aperture);
  const auto body = sines_of(scene.emitter, receiver);
  const double blocked = body ? intersection(lit, *body).size() : 0;
  return scene.reflectance * scene.radiance * (lit.size() - blocked);
}

std::vector<double> mirror_film(const MirrorScene& scene, const PlaneSegment& sensor,
                                std::size_t bins) {
  std::vector<double> film;
  const double width = 1 / static_cast<double>(bins);
  const auto at = [&](double position) {
    return mirror_point_irradiance(scene, {sensor.at(position), normal(sensor)});
  };
  for (std::size_t b = 0; b < bins; ++b) {
    const double from = static_cast<double>(b) * width;
    film.push_back(integral(at, from, from + width, film_accuracy) / width);
  }
  return film;
}

double fresnel_reflectance(double cosine, double index) {
  const double sine2 = (1 - cosine * cosine) / (index * index);  // of the refracted ray
  if (sine2 >= 1) return 1;
  const double refracted = std::sqrt(1 - sine2);
  const double s = (cosine - index * refracted) / (cosine + index * refracted);
  const double p = (index * cosine - refracted) / (index * cosine + refracted);
  return 0.5 * (s * s + p * p);
}

namespace {

// sin θ_t at which a ray from the receiver, refracted upwards, meets p.  The crossing point, h_t
// tan θ_t away, plus h_i tan θ_i is the way across; both grow with sin θ_t, so bisection finds it.
double sine_to(const RefractionScene& scene, PlanePoint receiver, PlanePoint p) {
  const double across = p.x - receiver.x;
  const double below = scene.interface.from.y - receiver.y, above = p.y - scene.interface.from.y;
  const double index = scene.index_below / scene.index_above;
  double low = 0, high = std::min(1.0, 1 / index);
  while (true) {
    const double u = 0.5 * (low + high), v = index * u;
    if (u <= low || u >= high) break;
    const double reached = below * u / std::sqrt(1 - u * u) + above * v / std::sqrt(1 - v * v);
    (reached < std::abs(across) ? low : high) = u;
  }
  return std::copysign(low, across);
}

}  // namespace

double refraction_point_irradiance(const RefractionScene& scene, PlanePoint receiver) {
  const double height = scene.interface.from.y;
  if (scene.interface.to.y != height || receiver.y >= height ||
      std::min(scene.emitter.from.y, scene.emitter.to.y) <= height)
    throw std::invalid_argument("the interface must be horizontal, between emitter and receiver");
  const double a = sine_to(scene, receiver, scene.emitter.from);
  const double b = sine_to(scene, receiver, scene.emitter.to);
  const auto aperture = sines_of(scene.interface, {receiver, {0, 1}});
  const Sines lit = intersection({std::min(a, b), std::max(a, b)}, *aperture);
  if (lit.size() == 0) return 0;
  const double index = scene.index_below / scene.index_above;
  const auto transmitted = [&](double sine) {
    const double outside = index * sine;
    return index * (1 - fresnel_reflectance(std::sqrt(1 - outside * outside), index));
  };
  return scene.radiance *
         integral(transmitted, lit.low, lit.high, {.absolute = 1e-14, .depth = 40});
}

std::vector<double> refraction_film(const RefractionScene& scene, double height,
                                    const std::vector<double>& edges) {
  std::vector<double> film;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const auto at = [&](double x) { return refraction_point_irradiance(scene, {x, height}); };
    film.push_back(integral(at, edges[b], edges[b + 1], {.absolute = 1e-12, .depth = 40}) /
                   (edges[b + 1] - edges[b]));
  }
  return film;
}

}  // namespace wander::test
