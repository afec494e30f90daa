#include "draw/figure/colour_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace wander::figure {
namespace {

// Every fifth colour of inferno [van der Walt and Smith 2015], 0xRRGGBB; the ones between differ
// from a straight line by at most 1 of 255.
constexpr std::array<std::uint32_t, 52> inferno{
    0x000004, 0x02020c, 0x050417, 0x0a0722, 0x10092d, 0x160b39, 0x1e0c45, 0x260c51, 0x2f0a5b,
    0x380962, 0x400a67, 0x490b6a, 0x510e6c, 0x59106e, 0x61136e, 0x69166e, 0x71196e, 0x781c6d,
    0x801f6c, 0x88226a, 0x902568, 0x982766, 0xa02a63, 0xa82e5f, 0xb0315b, 0xb73557, 0xbf3952,
    0xc63d4d, 0xcc4248, 0xd34743, 0xd94d3d, 0xdf5337, 0xe45a31, 0xe9612b, 0xed6925, 0xf1711f,
    0xf47918, 0xf78212, 0xf98b0b, 0xfa9407, 0xfb9d07, 0xfca60c, 0xfcb014, 0xfbba1f, 0xfac42a,
    0xf8cd37, 0xf6d746, 0xf4e156, 0xf2ea69, 0xf2f27d, 0xf5f992, 0xfcffa4};
constexpr std::array<std::uint32_t, 3> ink{0xffffff, 0xa8c4d6, 0x547ca4};
// RdBu of ColorBrewer [Harrower and Brewer 2003], from blue to red.
constexpr std::array<std::uint32_t, 11> blue_to_red{0x053061, 0x2166ac, 0x4393c3, 0x92c5de,
                                                    0xd1e5f0, 0xf7f7f7, 0xfddbc7, 0xf4a582,
                                                    0xd6604d, 0xb2182b, 0x67001f};

ColourMap interpolated(std::span<const std::uint32_t> anchors) {
  ColourMap map;
  const double intervals = static_cast<double>(anchors.size() - 1);
  for (std::size_t k = 0; k < map.size(); ++k) {
    const double place = intervals * static_cast<double>(k) / static_cast<double>(map.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double t = place - static_cast<double>(below);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto part = [&](std::uint32_t colour) { return (colour >> (16 - 8 * c)) & 0xff; };
      map[k][c] = static_cast<std::uint8_t>(
          std::lround((1 - t) * part(anchors[below]) + t * part(anchors[below + 1])));
    }
  }
  return map;
}

}  // namespace

const ColourMap& light_colours() {
  static const ColourMap map = interpolated(inferno);
  return map;
}

const ColourMap& ink_colours() {
  static const ColourMap map = interpolated(ink);
  return map;
}

const ColourMap& difference_colours() {
  static const ColourMap map = interpolated(blue_to_red);
  return map;
}

}  // namespace wander::figure
