#include "scenes/import/spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wander {

namespace {

constexpr int first = 380, last = 780, step = 10;  // nanometres

// The relative power of D65 [CIE 15:2004], every 10 nm.
constexpr double daylight[] = {49.9755, 54.6482, 82.7549, 91.486,  93.4318, 86.6823, 104.865,
                               117.008, 117.812, 114.861, 115.923, 108.811, 109.354, 107.802,
                               104.79,  107.689, 104.405, 104.046, 100.0,   96.3342, 95.788,
                               88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268,
                               80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.349,  61.604,
                               69.8856, 75.087,  63.5927, 46.4182, 66.8054, 63.3828};

double lobe(double x, double height, double centre, double below, double above) {
  const double t = (x - centre) * (x < centre ? below : above);
  return height * std::exp(-0.5 * t * t);
}

// The fit of Wyman, Sloan and Shirley [2013] to the colour matching functions, good to a percent.
Colour observed(double x) {
  return {lobe(x, 0.362, 442.0, 0.0624, 0.0374) + lobe(x, 1.056, 599.8, 0.0264, 0.0323) -
              lobe(x, 0.065, 501.1, 0.0490, 0.0382),
          lobe(x, 0.821, 568.8, 0.0213, 0.0247) + lobe(x, 0.286, 530.9, 0.0613, 0.0322),
          lobe(x, 1.217, 437.0, 0.0845, 0.0278) + lobe(x, 0.681, 459.0, 0.0385, 0.0725)};
}

Colour rec709(const Colour& xyz) {
  const auto [x, y, z] = xyz;
  return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
          -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
          0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

double value_at(const Spectrum& spectrum, double x) {
  const auto above = std::ranges::lower_bound(spectrum, x, {}, &Spectrum::value_type::first);
  if (above == spectrum.end() || (above == spectrum.begin() && above->first > x)) return 0;
  if (above == spectrum.begin()) return above->second;
  const auto below = above - 1;
  const double t = (x - below->first) / (above->first - below->first);
  return below->second + t * (above->second - below->second);
}

template <class Value>
Colour seen(Value&& value) {
  Colour sum{};
  double luminance = 0;
  for (int x = first; x <= last; ++x) {
    const Colour weight = observed(x);
    luminance += weight[1];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += weight[i] * value(x);
  }
  for (double& channel : sum) channel /= luminance;
  return rec709(sum);
}

double daylight_at(int x) {
  const int i = (x - first) / step, rest = (x - first) % step;
  const double t = static_cast<double>(rest) / step;
  return daylight[i] + (rest == 0 ? 0 : t * (daylight[i + 1] - daylight[i]));
}

}  // namespace

Colour equal_energy() { return rec709({1, 1, 1}); }

Colour colour_of(const Spectrum& spectrum, Light light) {
  Colour result;
  if (light == Light::emitted) {
    result = seen([&](int x) { return value_at(spectrum, x); });
  } else {
    result = seen([&](int x) { return daylight_at(x) * value_at(spectrum, x); });
    const Colour white = seen(daylight_at);
    for (std::size_t i = 0; i < 3; ++i) result[i] /= white[i];
  }
  const double most = light == Light::reflected ? 1 : std::numeric_limits<double>::infinity();
  for (double& channel : result) channel = std::clamp(channel, 0.0, most);
  return result;
}

}  // namespace wander
