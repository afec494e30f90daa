#include "tests/support/crossed_strings.h"

#include <cmath>

#include "core/exact/visibility.h"
#include "tests/support/quadrature.h"

namespace wander::test {

namespace {

Visibility visibility_of(std::span<const LambertSegment> scene) {
  std::vector<PlaneSegment> segments;
  for (const LambertSegment& s : scene) segments.push_back(s.segment);
  return Visibility(segments);
}

// E = Σ Le (sin θ2 - sin θ1) over what is visible of the emitting sides.
double gather(const Receiver& receiver, const Visibility& visibility,
              std::span<const LambertSegment> scene) {
  double irradiance = 0;
  for (const VisibleInterval& v : visibility.from(receiver)) {
    if (v.side != Side::front) continue;
    irradiance += scene[v.segment].radiance * (std::sin(v.theta_to) - std::sin(v.theta_from));
  }
  return irradiance;
}

}  // namespace

double point_irradiance(const Receiver& receiver, std::span<const LambertSegment> scene) {
  return gather(receiver, visibility_of(scene), scene);
}

double mean_irradiance(const PlaneSegment& sensor, std::span<const LambertSegment> scene) {
  const Visibility visibility = visibility_of(scene);
  const auto at = [&](double position) {
    return gather({sensor.at(position), normal(sensor)}, visibility, scene);
  };
  return integral(at, 0, 1, {.absolute = 1e-14, .depth = 40});
}

double crossed_strings(const PlaneSegment& a, const PlaneSegment& b) {
  const double one = length(b.from - a.from) + length(b.to - a.to);
  const double other = length(b.to - a.from) + length(b.from - a.to);
  return std::abs(one - other);
}

}  // namespace wander::test
