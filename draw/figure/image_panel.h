// An image in a figure, with words above it and the scale of its colours below it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "draw/figure/axis.h"
#include "draw/figure/block.h"
#include "draw/figure/colour_map.h"
#include "draw/figure/image_maps.h"

namespace wander::figure {

struct ImagePanel {
  std::vector<std::string> words;  // the first stands out
  std::string png;
  double aspect = 1;                  // height over width
  std::vector<std::uint8_t> colours;  // of the scale from left to right: red, green and blue
  std::function<Axis(Range page)> axis;
};

// Of pixels with one channel or three.  An image of few pixels has each of them several times, for
// what is drawn larger than it is would be smoothed.
std::string picture_png(std::span<const std::uint8_t> pixels, std::size_t width, std::size_t height,
                        std::size_t channels);
// Colours for numbers from `low` to `high`; one that is not known is grey.
std::string map_png(const PixelMap& map, const ColourMap& colours,
                    const std::function<std::uint8_t(double)>& tone);
std::vector<std::uint8_t> scale_of(const ColourMap& colours);

struct PanelSize {
  Vector image;
  double scale = 0;       // how wide; as the image, but no narrower than its words can be read
  std::size_t lines = 0;  // of words
  std::size_t title_lines = 1;  // of the scale's title

  double height() const;
};
// The image as wide as the room, if it is not higher than that.
PanelSize panel_size(const ImagePanel& panel, double width, double most_height);
void draw_panel(Svg& svg, const ImagePanel& panel, const PanelSize& size, Vector top_left,
                double width);

// Two side by side, as wide as the page and no higher than half of one.
Block panel_row(ImagePanel left, ImagePanel right, double page_width);

// Labels take so many points of the page each.
int ticks_in(Range page, double points);

}  // namespace wander::figure
