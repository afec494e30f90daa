#include "draw/figure/map_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wander::figure {
namespace {

double aspect_of(const PixelMap& map) {
  return static_cast<double>(map.height) / static_cast<double>(map.width);
}

}  // namespace

ImagePanel log_panel(std::vector<std::string> words, const PixelMap& map, const ToneScale& scale,
                     const Quantity& quantity) {
  return {std::move(words),
          map_png(map, light_colours(), [=](double value) { return scale.tone(value); }),
          aspect_of(map), scale_of(light_colours()),
          [=](Range page) { return make_log_axis(quantity, scale.domain, page); }};
}

ImagePanel difference_panel(std::vector<std::string> words, const PixelMap& map, double most) {
  const auto tone = [most](double z) {
    const double place = std::clamp((z + most) / (2 * most), 0., 1.);
    return static_cast<std::uint8_t>(std::lround(255 * place));
  };
  return {std::move(words), map_png(map, difference_colours(), tone), aspect_of(map),
          scale_of(difference_colours()), [most](Range page) {
            return make_axis({"z: difference / standard error of both", ""}, {-most, most}, page,
                             ticks_in(page, 18));
          }};
}

ImagePanel share_panel(std::vector<std::string> words, const PixelMap& map) {
  return {std::move(words),
          map_png(map, light_colours(),
                  [](double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); }),
          aspect_of(map), scale_of(light_colours()), [](Range page) {
            return make_axis({"share", ""}, {0, 1}, page, ticks_in(page, 34));
          }};
}

double largest_shown(const std::vector<PixelMap>& differences) {
  constexpr double usual = 4, beyond = 0.002, most = 100;
  std::vector<double> sizes;
  for (const PixelMap& map : differences)
    for (const double z : map.values)
      if (std::isfinite(z)) sizes.push_back(std::abs(z));
  if (sizes.empty()) return usual;
  const auto at = sizes.begin() +
                  static_cast<std::ptrdiff_t>((1 - beyond) * static_cast<double>(sizes.size() - 1));
  std::ranges::nth_element(sizes, at);
  return std::clamp(std::ceil(*at), usual, most);
}

}  // namespace wander::figure
